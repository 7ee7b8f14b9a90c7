;; tape/factor.lisp: a straight-line program with fewer operations: what sums and products share
;; in part, common factors; its order.
;;
;; ($gs__fewer code outputs fixed fresh): code: Maxima list of entries [name, expression, block,
;; number, symbols], oldest first; outputs: expressions; fixed: hash table, names that must stay
;; (sines and cosines); fresh: function that gives a new symbol. Result: [code, outputs], the code
;; in an order in which it can be executed.
;;
;; A node is (kind constant . parts): sum: constant + sum of c*name, parts ((name . c) ...);
;; product: constant * product of names, parts ((name . 1) ...); other: an expression that is left
;; alone.
;;   flatten   a sum (product) used once in a sum (product) is written there;
;;   cancel    x - b with x = a + b is a: one sum less, and no cancellation of rounded numbers;
;;   factor    a*x + a*y, the products used once, is a*(x + y);
;; pairs two terms (factors) that stand together in two or more sums (products) get a name, the most
;; frequent first.
(in-package :maxima)

; form: (expression constant . parts) as it came, or nil
(defstruct gs-node kind const parts block number form)

(defun gs-node-number-p (e) (or (numberp e) (and (consp e) (eq (caar e) 'rat))))
(defun gs-sum-plus (a b)
  (if (and (numberp a) (numberp b)) (+ a b) (simplifya (list '(mplus) a b) nil)))
(defun gs-sum-times (a b)
  (if (and (numberp a) (numberp b)) (* a b) (simplifya (list '(mtimes) a b) nil)))

;; (name . coefficient) of a term c*name, or nil
(defun gs-term (e)
  (cond ((symbolp e) (cons e 1))
        ((and (consp e)
              (eq (caar e) 'mtimes)
              (= (length e) 3)
              (gs-node-number-p (cadr e))
              (symbolp (caddr e)))
         (cons (caddr e) (cadr e)))))

;; A number in a product is kept under a name of its own, so that the passes see it as they see a
;; parameter.
(defvar *gs-names*)                          ; number -> its name
(defvar *gs-numbers*)                        ; name -> number
(defun gs-name-of (c)
  (let ((key (format nil "~s" c)))
    (or (gethash key *gs-names*)
        (let ((s (make-symbol key)))
          (setf (gethash s *gs-numbers*) c (gethash key *gs-names*) s)))))
(defun gs-sum-value (s) (or (gethash s *gs-numbers*) s))
(defun gs-sum-negative-p (c) (if (numberp c) (minusp c) (minusp (cadr c))))
(defun gs-sign (c) (if (gs-sum-negative-p c) -1 1))
(defun gs-abs (c) (if (gs-sum-negative-p c) (gs-sum-times -1 c) c))

;; the parts of a product with those of the size of the number c
(defun gs-scaled (c parts)
  (if (eql (gs-abs c) 1) parts (cons (cons (gs-name-of (gs-abs c)) 1) parts)))

;; The node of an expression; put: keeps a new node under a new name, which it returns.
(defun gs-enter-node (e block number put)
  (flet ((node (kind const parts)
           (make-gs-node :kind kind :const const :parts parts :block block :number number)))
    (let* ((op (and (consp e) (caar e)))
           (n (case op
                (mplus (gs-sum-of (cdr e) #'node put))
                (mtimes (gs-product-of (cdr e) #'node)))))
      (cond (n (setf (gs-node-form n) (list* e (gs-node-const n) (gs-node-parts n)))
               n)
            (t (node 'other e nil))))))

;; the node of a sum of numbers and terms c*name, or nil; a c that is not 1 or -1 goes into a
;; product of its own
(defun gs-sum-of (terms node put)
  (let ((const 0) (parts nil))
    (dolist (x terms (funcall node 'sum const (nreverse parts)))
      (let ((p (gs-term x)))
        (cond ((gs-node-number-p x) (setq const (gs-sum-plus const x)))
              ((null p) (return nil))
              ((member (cdr p) '(1 -1)) (push p parts))
              (t (let ((scaled (gs-scaled (cdr p) (list (cons (car p) 1)))))
                   (push (cons (funcall put (funcall node 'product 1 scaled)) (gs-sign (cdr p)))
                         parts))))))))

;; the node of a product of numbers and names, or nil
(defun gs-product-of (factors node)
  (let ((const 1) (parts nil))
    (dolist (x factors
               (funcall node 'product (gs-sign const) (nreverse (gs-scaled const parts))))
      (cond ((gs-node-number-p x) (setq const (gs-sum-times const x)))
            ((symbolp x) (push (cons x 1) parts))
            (t (return nil))))))

(defun gs-expression (n)
  (if (and (gs-node-form n)
           (eql (gs-node-const n) (cadr (gs-node-form n)))
           (equal (gs-node-parts n) (cddr (gs-node-form n))))
      (car (gs-node-form n))
      (gs-new-expression n)))
(defun gs-new-expression (n)
  (case (gs-node-kind n)
    (other (gs-node-const n))
    (sum (simplifya
           (list* '(mplus) (gs-node-const n)
                  (mapcar #'(lambda (p) (gs-sum-times (cdr p) (gs-sum-value (car p))))
                          (gs-node-parts n)))
           nil))
    (t (simplifya
         (list* '(mtimes) (gs-node-const n)
                (mapcar #'(lambda (p) (gs-sum-value (car p))) (gs-node-parts n)))
         nil))))

(defun gs-symbols (e) (cdr (gs-symbol-list e)))
(defun gs-symbol-list (e)
  (let ((l nil))
    (gs-rec ((walk (x)
               (cond ((symbolp x) (unless (or (null x) ($constantp x)) (pushnew x l)))
                     ((consp x) (mapc #'walk (cdr x))))))
      (walk e))
    (cons '(mlist simp) l)))
(defun gs-operands (n)
  (if (eq (gs-node-kind n) 'other) (gs-symbols (gs-node-const n)) (mapcar #'car (gs-node-parts n))))

(defun gs-uses (names nodes outputs)
  (let ((uses (make-hash-table :test #'eq)))
    (dolist (v names) (dolist (s (gs-operands (gethash v nodes))) (incf (gethash s uses 0))))
    (dolist (e outputs) (dolist (s (gs-symbols e)) (incf (gethash s uses 0) 2)))
    uses))

;; the names (oldest first) that the outputs need; the nodes of the others go
(defun gs-needed (names nodes outputs fixed)
  (let ((used (make-hash-table :test #'eq)) (kept nil))
    (flet ((use (l) (dolist (s l) (setf (gethash s used) t))))
      (dolist (e outputs) (use (gs-symbols e)))
      (dolist (v (reverse names) kept)
        (cond ((or (gethash v used) (gethash v fixed))
               (use (gs-operands (gethash v nodes)))
               (push v kept))
              (t (remhash v nodes)))))))

;; a sum or product used once, in one of its kind, is written there
(defun gs-flatten (names nodes uses fixed)
  (dolist (v names)
    (let ((n (gethash v nodes)))
      (unless (eq (gs-node-kind n) 'other)
        (setf (gs-node-parts n)
              (mapcan #'(lambda (p)
                          (let ((m (gethash (car p) nodes)))
                            (cond ((and m
                                        (eq (gs-node-kind m) (gs-node-kind n))
                                        (= (gethash (car p) uses 0) 1)
                                        (not (gethash (car p) fixed)))
                                   (remhash (car p) nodes)
                                   (cond ((eq (gs-node-kind n) 'sum)
                                          (setf (gs-node-const n)
                                                (gs-sum-plus (gs-node-const n)
                                                  (gs-sum-times (cdr p) (gs-node-const m))))
                                          (mapcar #'(lambda (q)
                                                      (cons (car q) (gs-sum-times (cdr p) (cdr q))))
                                                  (gs-node-parts m)))
                                         (t (setf (gs-node-const n)
                                                  (gs-sum-times (gs-node-const n)
                                                                (gs-node-const m)))
                                            (copy-list (gs-node-parts m)))))
                                  (t (list p))))) (gs-node-parts n)))
        (gs-merge n)))))

;; equal names of a sum are one term, the numbers of a product one number
(defun gs-merge (n)
  (if (eq (gs-node-kind n) 'sum)
      (let ((l nil))
        (dolist (p (gs-node-parts n))
          (let ((old (assoc (car p) l)))
            (if old (setf (cdr old) (gs-sum-plus (cdr old) (cdr p)))
                (push (cons (car p) (cdr p)) l))))
        (setf (gs-node-parts n) (nreverse (remove-if #'(lambda (p) (eql (cdr p) 0)) l))))
      (let ((numbers (remove-if-not #'(lambda (p) (gethash (car p) *gs-numbers*))
                                    (gs-node-parts n))))
        (when (cdr numbers)
          (let ((c 1))
            (dolist (p numbers) (setq c (gs-sum-times c (gs-sum-value (car p)))))
            (setf (gs-node-parts n)
                  (gs-scaled c
                             (remove-if #'(lambda (p) (member p numbers)) (gs-node-parts n)))))))))

;; c*x in a sum whose other terms take away again one of the two terms of x = a + b: what is left of
;; it
(defun gs-cancel (names nodes)
  (dolist (v names)
    (let ((n (gethash v nodes)))
      (when (eq (gs-node-kind n) 'sum)
        (loop
          for
          found
          =
          (gs-cancelled n nodes)
          while
          found
          do
          (destructuring-bind (x other left) found
            (setf (gs-node-parts n)
                  (cons left (remove other (remove x (gs-node-parts n) :test #'eq) :test #'eq)))
            (gs-merge n)))))))
;; (term, the term that cancels a part of it, what is left of it) of a sum, or nil
(defun gs-cancelled (n nodes)
  (dolist (x (gs-node-parts n))
    (let ((m (gethash (car x) nodes)))
      (when (and m (eq (gs-node-kind m) 'sum) (eql (gs-node-const m) 0)
                 (= (length (gs-node-parts m)) 2))
        (dolist (p (gs-node-parts m))
          (let ((other (assoc (car p) (gs-node-parts n))))
            (when (and other (equal (cdr other) (gs-sum-times -1 (gs-sum-times (cdr x) (cdr p)))))
              (let ((q (if (eq p (car (gs-node-parts m))) (cadr (gs-node-parts m))
                           (car (gs-node-parts m)))))
                (return-from
                  gs-cancelled (list x other (cons (car q) (gs-sum-times (cdr x) (cdr q)))))))))))))

;; the product, used once, that the term p of a sum stands for, or nil
(defun gs-product-used-once (p nodes uses fixed)
  (let ((m (gethash (car p) nodes)))
    (and m
         (eq (gs-node-kind m) 'product)
         (= (gethash (car p) uses 0) 1)
         (not (gethash (car p) fixed))
         m)))

;; the name that is a factor of most products of a sum that are used once, of two or more; or nil
(defun gs-commonest-factor (n nodes uses fixed)
  (let ((count nil) (best nil))
    (dolist (p (gs-node-parts n))
      (let ((m (gs-product-used-once p nodes uses fixed)))
        (when m
          (dolist (x (remove-duplicates (mapcar #'car (gs-node-parts m))))
            (let ((c (assoc x count))) (if c (incf (cdr c)) (push (cons x 1) count)))))))
    (dolist (c (reverse count) (car best))
      (if (and (> (cdr c) 1) (or (null best) (> (cdr c) (cdr best)))) (setq best c)))))

;; the term p, the product m, without its factor x: (name . c), the name nil if only c is left
(defun gs-without-factor (x p m nodes)
  (let ((parts (remove x (gs-node-parts m) :key #'car :count 1))
        (c (gs-sum-times (cdr p) (gs-node-const m))))
    (cond ((null (cdr parts))
           (remhash (car p) nodes)
           (cons (if parts (caar parts) nil) c))
          (t (setf (gs-node-parts m) parts (gs-node-const m) 1)
             (cons (car p) c)))))

;; (the terms of a sum that hold x, without it; the others), each list the last first
(defun gs-split-at-factor (x n nodes uses fixed)
  (let ((inner nil) (others nil))
    (dolist (p (gs-node-parts n) (list inner others))
      (let ((m (gs-product-used-once p nodes uses fixed)))
        (if (and m (assoc x (gs-node-parts m)))
            (push (gs-without-factor x p m nodes) inner)
            (push p others))))))

;; the term of the sum n that stands for x*(inner): a new product v of x and a new sum s; where a,
;; -a or nothing is left, x with that sign
(defun gs-factored (x inner n s v uses put)
  (let ((const 0))
    (dolist (i inner) (if (null (car i)) (setq const (gs-sum-plus const (cdr i)))))
    (setq inner (nreverse (remove nil inner :key #'car)))
    (flet ((keep (name kind const parts)
             (funcall put name
                      (make-gs-node :kind kind :const const :parts parts :block (gs-node-block n)
                                :number (gs-node-number n)))
             (setf (gethash name uses) 1)))
      (cond ((or inner (not (member const '(0 1 -1))))
             (keep s 'sum const inner)
             (keep v 'product 1 (list (cons x 1) (cons s 1)))
             (cons v 1))
            (t (cons x const))))))

;; one round over a sum: the name that is a factor of most of its products that are used once is
;; taken out of them; new nodes by `fresh`
(defun gs-factor-sum (n nodes uses fixed fresh put)
  (let ((x (gs-commonest-factor n nodes uses fixed)))
    (when x
      (let* ((s (funcall fresh)) (v (funcall fresh))
             (split (gs-split-at-factor x n nodes uses fixed)))
        (setf (gs-node-parts n)
              (cons (gs-factored x (first split) n s v uses put) (nreverse (second split))))
        (gs-merge n)
        t))))

;; pairs of terms of sums as ((a . b) . ratio), of factors as (a . b)
(defun gs-pair (kind p q)
  (if (string> (symbol-name (car p)) (symbol-name (car q))) (rotatef p q))
  (if (eq kind 'sum)
      (list (car p) (car q) (gs-sum-times (cdr q) (gs-sum-inverse (cdr p))))
      (list (car p) (car q) 1)))
(defun gs-sum-inverse (c) (if (or (eql c 1) (eql c -1)) c (simplifya (list '(mexpt) c -1) nil)))

;; A heap (best-item . heaps); the worse of two goes below the better.
(defun gs-meld (a b better)
  (cond ((null a) b) ((null b) a)
        ((funcall better (car a) (car b)) (list* (car a) b (cdr a)))
        (t (list* (car b) a (cdr b)))))
(defun gs-rest (heap better)
  (let ((pairs nil) (all nil))
    (do ((l (cdr heap) (cddr l))) ((null l)) (push (gs-meld (car l) (cadr l) better) pairs))
    (dolist (h pairs all) (setq all (gs-meld all h better)))))

;; The most frequent pair is taken first, of several the one that is needed first. Where a pair
;; stands can only become less while another is taken, so a pair that comes to the top of the heap
;; is looked at again.
(defun gs-share-pairs (kind names nodes fresh put)
  (let ((where (make-hash-table :test #'eq)) (two (make-hash-table :test #'eq))
        (ids (make-hash-table :test #'eq)) (pairs (make-hash-table)) (heap nil))
    (gs-rec ((id (s) (or (gethash s ids) (setf (gethash s ids) (hash-table-count ids))))
             ;; one list for each pair: Lisp's own hash of a list of names lets thousands share
             ;; a place
             (pair (p q)
               (let* ((k (gs-pair kind p q)) (n (+ (* 16777216 (id (first k))) (id (second k)))))
                 (or (find (third k) (gethash n pairs) :key #'third :test #'equal)
                     (progn (push k (gethash n pairs)) k))))
             (each-pair (n f)
               (do ((l (gs-node-parts n) (cdr l)))
                   ((null (cdr l)))
                 (dolist (q (cdr l)) (unless (eq (caar l) (car q)) (funcall f (pair (car l) q))))))
             (add (n)
               (when (< (length (gs-node-parts n)) 40)
                 (each-pair n #'(lambda (k) (pushnew n (gethash k where))))))
             (del (n)
               (when (< (length (gs-node-parts n)) 40)
                 (each-pair
                   n #'(lambda (k) (setf (gethash k where) (delete n (gethash k where)))))))
             (standing (k)  ; (count number pair) of a pair that stands in two places or more
               (let* ((l (gethash k where)) (c (+ (length l) (if (gethash k two) 1 0))))
                 (and l (> c 1) (list c (loop for n in l minimize (gs-node-number n)) k))))
             (better (a b)
               (or (> (first a) (first b))
                   (and (= (first a) (first b))
                        (or (< (second a) (second b))
                            (and (= (second a) (second b)) (gs-before (third a) (third b)))))))
             (note (k)
               (let ((r (standing k))) (when r (setq heap (gs-meld (list r) heap #'better))))))
      (dolist (v names)
        (let ((n (gethash v nodes)))
          (when (and n (eq (gs-node-kind n) kind) (cddr (gs-node-parts n))) (add n))))
      ;; sums of two are sought too: their pair exists already
      (dolist (v names)
        (let ((n (gethash v nodes)))
          (when (and n
                     (eq (gs-node-kind n) kind)
                     (= (length (gs-node-parts n)) 2)
                     (eql (gs-node-const n) (if (eq kind 'sum) 0 1)))
            (setf (gethash (pair (first (gs-node-parts n)) (second (gs-node-parts n))) two) v))))
      (maphash #'(lambda (k l) (declare (ignore l)) (note k)) where)
      (do ()
          ((null heap))
        (let* ((top (car heap)) (best (third top)))
          (setq heap (gs-rest heap #'better))
          (if (not (equal top (standing best)))
              (note best)
              (let* ((l (stable-sort (copy-list (gethash best where)) #'< :key #'gs-node-number))
                     (v (gethash best two)) (m (and v (gethash v nodes))))
                (unless m
                  (setq v (funcall fresh)
                        m (make-gs-node :kind kind :const (if (eq kind 'sum) 0 1) :parts
                                    (list (cons (first best) 1) (cons (second best) (third best)))
                                    :block (gs-node-block (car l)) :number
                                    (gs-node-number (car l))))
                  (funcall put v m)
                  (setf (gethash best two) v))
                (dolist (n l)
                  (del n)
                  (let* ((p (assoc (first best) (gs-node-parts n)))
                         (c (gs-sum-times
                              (cdr p)
                              (gs-sum-inverse (cdr (assoc (first best) (gs-node-parts m)))))))
                    (setf (gs-node-parts n)
                          (cons (cons v (if (eq kind 'sum) c 1))
                                (remove (second best)
                                        (remove (first best) (gs-node-parts n) :key #'car :count 1)
                                        :key
                                        #'car :count 1))))
                  (when (cddr (gs-node-parts n)) (add n)))
                (dolist (n l)
                  (when (cddr (gs-node-parts n))
                    (each-pair
                      n
                      #'(lambda (k)
                          (when (or (eq (first k) v) (eq (second k) v)) (note k)))))))))))))
(defun gs-before (a b)
  (let ((u (symbol-name (first a))) (v (symbol-name (first b))) (x (symbol-name (second a)))
        (y (symbol-name (second b))))
    (cond ((string/= u v) (string< u v))
          ((string/= x y) (string< x y))
          (t (string< (format nil "~a" (third a)) (format nil "~a" (third b)))))))

;; names in an order in which each stands behind its operands, the oldest first
(defun gs-ordered (names nodes outputs)
  (let ((done (make-hash-table :test #'eq)) (l nil))
    (gs-rec ((visit (v)
               (let ((n (gethash v nodes)))
                 (when (and n (not (gethash v done)))
                   (setf (gethash v done) t)
                   (mapc #'visit (gs-operands n))
                   (push v l)))))
      (dolist (v (stable-sort (copy-list names) #'<
                   :key #'(lambda (v) (let ((n (gethash v nodes))) (if n (gs-node-number n) 0)))))
        (visit v))
      (dolist (e outputs) (mapc #'visit (gs-symbols e))))
    (nreverse l)))

(defun $gs__fewer (code outputs fixed fresh passes)
  (let ((nodes (make-hash-table :test #'eq)) (names nil) (outs (cdr outputs))
        (*gs-names* (make-hash-table :test #'equal)) (*gs-numbers* (make-hash-table :test #'eq)))
    (gs-rec ((put (v n) (setf (gethash v nodes) n) (push v names))
             (new () (gs-tick) (mfuncall fresh))
             (live () (setq names (remove-if-not #'(lambda (v) (gethash v nodes)) names)))
             (old-first ()
               (live)
               (stable-sort (copy-list names) #'<
                            :key #'(lambda (v) (gs-node-number (gethash v nodes))))))
      (dolist (e (cdr code))
        (put (second e)
             (gs-enter-node (third e) (fourth e) (fifth e)
                            #'(lambda (n) (let ((v (new))) (put v n) v)))))
      (let ((passes (cdr passes)))
        (gs-flatten (gs-ordered names nodes outs) nodes (gs-uses names nodes outs) fixed)
        (live)
        (when (member '$cancel passes)
          (gs-cancel (gs-ordered names nodes outs) nodes)
          (setq names (gs-needed (gs-ordered names nodes outs) nodes outs fixed))
          (gs-flatten (gs-ordered names nodes outs) nodes (gs-uses names nodes outs) fixed)
          (live))
        (when (member '$factor passes)
          (let ((uses (gs-uses names nodes outs)))
            (dolist (v (old-first))
              (let ((n (gethash v nodes)))
                (when (and n (eq (gs-node-kind n) 'sum))
                  (loop while (gs-factor-sum n nodes uses fixed #'new #'put)))))))
        (when (member '$pairs passes)
          (gs-share-pairs 'sum (old-first) nodes #'new #'put)
          (gs-share-pairs 'product (old-first) nodes #'new #'put)))
      (live)
      (list '(mlist simp)
            (cons '(mlist simp)
                  (mapcar #'(lambda (v) (gs-entry v (gethash v nodes)))
                          (gs-ordered names nodes outs)))
            outputs))))
(defun gs-entry (v n)
  (let ((e (gs-expression n)))
    (list '(mlist simp) v e (gs-node-block n) (gs-node-number n) (gs-symbol-list e))))

;;; ------------------------------------------------------------------------------------------ order

;; The code (entries [name, expression, block]) in the order in which the results ask for it, each
;; entry behind what it needs. Long recursions take more time in that order than link by link, as
;; the tape has them.
(defun $gs__by_need (code results)
  (let ((entry (make-hash-table :test #'eq)) (found nil))
    (dolist (e (cdr code)) (setf (gethash (second e) entry) e))
    (gs-rec ((visit (x) (dolist (s (cdr ($gs__symbols x)))
                          (let ((e (gethash s entry)))
                            (when e
                              (remhash s entry)
                              (visit (third e))
                              (push e found))))))
      (mapc #'visit (cdr results)))
    (cons '(mlist simp) (nreverse found))))

;; Everything on a tape (its table of entries and natures) that can be formed of what is known,
;; constants apart, and what is needed, oldest first.
(defun $gs__everything (entries nature known needed)
  (let ((ready (make-hash-table :test #'eq)) (wanted (make-hash-table :test #'eq)) (all nil)
        (found nil))
    (dolist (e (cdr needed)) (setf (gethash (second e) wanted) t))
    (dolist (s (cdr known)) (setf (gethash s ready) t))
    (maphash #'(lambda (s e) (unless (eq (gethash s nature) '$constant) (push e all))) entries)
    (dolist (e (stable-sort all #'< :key #'fifth) (cons '(mlist simp) (nreverse found)))
      (when (or (gethash (second e) wanted)
                (loop for s in (cdr (sixth e))
                      always (or (gethash s ready) (eq (gethash s nature) '$constant))))
        (setf (gethash (second e) ready) t)
        (push e found)))))
