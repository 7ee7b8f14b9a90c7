;;; trig/simplify.lisp: the search for the shortest form of a sum of products of sines and cosines
;;; (trig/simplify.mac tells what it does; twenty times faster than in Maxima).
(in-package :maxima)

;;; The terms of an expanded sum by what stands beside their sines and cosines:
;;; ((mlist) ((mlist) c t1 t2 ...) ...) with e = sum of c*(t1 + t2 + ...); a t is a number times
;;; powers of symbols in the hash table.

(defun gs-trig-factor-p (f table)
  (cond ((numberp f) t)
        ((symbolp f) (gethash f table))
        ((eq (caar f) 'rat) t)
        ((eq (caar f) 'mexpt)
         (and (symbolp (cadr f)) (integerp (caddr f)) (gethash (cadr f) table)))))

(defun gs-product (factors)   ; of factors that stood in this order in a simplified product
  (cond ((null factors) 1) ((null (cdr factors)) (car factors)) (t (cons '(mtimes simp) factors))))

(defun $gs__trig_classes (e table)
  (gs-tick)
  (let ((classes (make-hash-table :test #'equal)) (keys nil))
    (mapc #'(lambda (term)
              (let ((own nil) (beside nil))
                (mapc #'(lambda (f)
                          (if (consp f) (setq f ($gs__unmarked f)))
                          (if (gs-trig-factor-p f table)
                              (setq own (cons f own))
                              (setq beside (cons f beside))))
                      (if (and (consp term) (eq (caar term) 'mtimes)) (cdr term) (list term)))
                (setq own (gs-product (reverse own)) beside (gs-product (reverse beside)))
                (let ((others (gethash beside classes)))
                  (if (null others) (setq keys (cons beside keys)))
                  (setf (gethash beside classes) (cons own others)))))
          (if (and (consp e) (eq (caar e) 'mplus)) (cdr e) (list e)))
    (cons '(mlist simp)
          (mapcar #'(lambda (k) (cons '(mlist simp) (cons k (reverse (gethash k classes)))))
                  (reverse keys)))))

;;; whether an expression has more than `most` nodes
(defun $gs__is_longer (e most)
  (gs-rec ((count-nodes (x)
             (when (< (decf most) 0) (return-from $gs__is_longer t))
             (unless (atom x) (mapc #'count-nodes (cdr x)))))
    (count-nodes e)
    nil))

(defun $gs__nodes (e)
  (gs-rec ((nodes (x) (if (atom x) 1 (reduce #'+ (mapcar #'nodes (cdr x)) :initial-value 1))))
    (nodes e)))

;;; ----------------------------------------------------------------------------------------- terms

(defun gs-terms-of (e) (if (gs-sum-p e) (cdr e) (list e)))
;;; number of terms of an expanded expression
(defun $gs__terms (e) (cond ((gs-sum-p e) (length (cdr e))) ((eql e 0) 0) (t 1)))
(defun $gs__term_list (e) (gs-list (gs-terms-of e)))

;;; (monomial . number) of a term
(defun gs-monomial (term)
  (cond ((mnump term) (cons 1 term))
        ((and (gs-product-p term) (mnump (cadr term)))
         (cons (gs-multiply (cddr term)) (cadr term)))
        (t (cons term 1))))
(defun gs-monomials (e) (mapcar #'gs-monomial (gs-terms-of e)))
(defun gs-degree (m)
  (cond ((atom m) (if (eql m 1) 0 1))
        ((and (gs-power-p m) (integerp (caddr m))) (abs (caddr m)))
        ((gs-product-p m) (loop for f in (cdr m) sum (gs-degree f)))
        (t 1)))
(defun gs-absolute (number) (abs (if (ratnump number) (gs-rational number) number)))
;;; what a term costs: that it is there, then its number (1 is best), then its length
(defun gs-term-size (monomial number)
  (+ (expt 10 6) (* (expt 10 3) (gs-absolute number)) (gs-degree monomial)))
(defun gs-polynomial-size (p)
  (loop for (monomial . number) in (gs-monomials p) sum (gs-term-size monomial number)))

;;; ------------------------------------------------------------------------------------ identities

;;; what the memory of a rule set holds under a key, made by f where it does not yet
(defun gs-in-memory (ruleset key f)
  (let ((memo ($@-function ruleset '$memo)))
    (or ($gs__get memo key) ($gs__put memo key (funcall f)))))

;;; the identities among the atoms (numbers) present in a polynomial: lists of different
;;; monomials, two or three, whose sum is zero
(defun gs-identities (ruleset present)
  (gs-in-memory ruleset (gs-list present) #'(lambda () (gs-find-identities ruleset present))))
(defun gs-find-identities (ruleset present)
  (let* ((known (cdr ($@-function ruleset '$known)))
         (sums (loop for i in present
                     append (loop for j in present append (gs-angle-sums known i j)))))
    (flet ((atom-of (k) (gs-atom ruleset k)))
      (append
        (loop for (nil i j k sign) in (cdr ($unique (gs-list sums)))
              append (if (eql i j)
                         (gs-double-identities (atom-of i) (atom-of k))
                         (gs-sum-identities (atom-of i) (atom-of j) (atom-of k) sign)))
        (loop for i in present
              collect (destructuring-bind (s c angle) (cdr (atom-of i))
                        (declare (ignore angle))
                        (list (power s 2) (power c 2) -1)))))))
(defun gs-atom (ruleset k) (nth k ($@-function ruleset '$atoms)))

;;; the relations angle(a) + angle(b) = sign*angle(c) between the atoms i < j and a known third, as
;;; [a, b, c, sign]; known: [angle as a sum, number of its atom]
(defun gs-angle-sums (known i j)
  (when (< i j)
    (let ((x (cadr (nth (1- i) known))) (y (cadr (nth (1- j) known))) (found nil))
      (flet ((third-of (angle) (caddr (find angle known :key #'cadr :test #'alike1)))
             (relation (a b c sign) (push (gs-list (list a b c sign)) found)))
        (let ((k (third-of (add x y)))) (when k (relation i j k 1)))
        (let ((k (third-of (sub (gs-minus x) y)))) (when k (relation i j k -1)))
        (let ((k (third-of (sub x y)))) (when k (relation (min j k) (max j k) i 1)))
        (let ((k (third-of (sub y x)))) (when k (relation (min i k) (max i k) j 1))))
      found)))

;;; the six forms of one sum of angles, a + b = sign*c (atoms)
(defun gs-sum-identities (a b c sign)
  (destructuring-bind (sa ca sb cb sc cc) (list (cadr a) (caddr a) (cadr b) (caddr b)
                                                (mul sign (cadr c)) (caddr c))
    (flet ((minus (&rest factors) (muln (cons -1 factors) nil)))
      (list (list (minus sc) (mul sa cb) (mul ca sb))
            (list (minus cc) (mul ca cb) (minus sa sb))
            (list (minus sa) (mul sc cb) (minus cc sb))
            (list (minus ca) (mul cc cb) (mul sc sb))
            (list (minus sb) (mul sc ca) (minus cc sa))
            (list (minus cb) (mul cc ca) (mul sc sa))))))

;;; those of an angle and its double, 2*a = c: q beside 2*q in an expression of the user
(defun gs-double-identities (a c)
  (destructuring-bind (sa ca s2 c2) (list (cadr a) (caddr a) (cadr c) (caddr c))
    (flet ((times (&rest factors) (muln factors nil)))
      (list (list (times -1 s2) (times 2 sa ca))
            (list (times -1 c2) (power ca 2) (times -1 (power sa 2)))
            (list (times -1 c2) 1 (times -2 (power sa 2)))
            (list (times -1 c2) (times 2 (power ca 2)) -1)
            (list (times -1 sa) (times s2 ca) (times -1 c2 sa))
            (list (times -1 ca) (times c2 ca) (times s2 sa))))))

;;; ----------------------------------------------------------------------------- the shortest form

;;; An expanded expression with its sums of sines and cosines in their shortest forms. Terms are put
;;; together by what stands beside their sines and cosines; what is left, small polynomials in sines
;;; and cosines with numbers, comes again and again and is remembered.
(defun $gs__shorten (ruleset e)
  (if (< ($gs__terms e) 2)
      ($gs__unmarked e)
      (gs-long-sum
        (loop for (nil beside . own) in (cdr ($gs__trig_classes e ($@-function ruleset '$table)))
              append (if (cdr own)
                         (mapcar #'(lambda (x) (mul beside x))
                                 (gs-terms-of (gs-best ruleset (addn own nil))))
                         (list (mul beside (car own))))))))
;;; a sum of many terms: in falling order nothing has to be moved
(defun gs-long-sum (terms) (addn (reverse (cdr ($sort (gs-list terms)))) nil))

;;; The shortest form found of a polynomial in sines and cosines with numbers. What all terms have
;;; in common stays apart: every symbol is in one monomial of an identity at most, so nothing is
;;; missed.
(defun gs-best (ruleset p)
  (if (< ($gs__terms p) 2) p
    (gs-in-memory ruleset p
      #'(lambda ()
          (let ((common (reduce #'$gcd (cdr p))))
            (when (mnegp (cdr (gs-monomial (cadr p))))
              (setq common (gs-minus common)))
            (let ((primitive (addn (mapcar #'(lambda (x) (div x common)) (cdr p)) nil)))
              ($expand
                (mul common
                     (gs-in-memory ruleset (gs-list (list primitive))
                       #'(lambda () (gs-find-best ruleset primitive)))))))))))
(defun gs-find-best (ruleset p)
  (let ((present (gs-present ruleset p)))
    (cond ((null present) p)
          ((gs-zero-p ruleset p) 0)
          (t (let* ((ids (gs-identities ruleset present))
                    (short (gs-descend ids p))
                    (on-circle (gs-on-circle ruleset present p))
                    (even (if (alike1 on-circle p) p (gs-descend ids on-circle))))
               (if (and (not (alike1 even p))
                        (< (gs-polynomial-size even) (gs-polynomial-size short)))
                   even
                   short))))))
;;; numbers of the atoms in an expression, ascending
(defun gs-present (ruleset e)
  (let ((table ($@-function ruleset '$table)))
    (stable-sort (remove-duplicates
                   (loop for s in (cdr ($listofvars e)) when (gethash s table) collect it))
                 #'<)))
;;; zero at an exact point, and then identically
(defun gs-zero-p (ruleset p)
  (let ((point (gs-in-memory ruleset '$point
                 #'(lambda () (mfuncall '$gs__rational_point ruleset 1)))))
    (and (eql ($substitute point p) 0) (mfuncall '$gs__zerop ruleset p))))

;;; sq^n reduced to a first power: the normal form on each circle
(defun gs-on-circle (ruleset present e)
  (dolist (k present e)
    (destructuring-bind (s c angle) (cdr (gs-atom ruleset k))
      (declare (ignore angle))
      (let ((circle (addn (list (power s 2) (power c 2) -1) nil)) (n ($hipow e s)))
        (when (integerp n)
          (loop for i from n downto 2
                do (setq e ($expand
                             (sub e (muln (list ($coeff e s i) (power s (- i 2)) circle)
                                          nil))))))))))

;;; zeros f*x*(t1 + t2 + t3) taken away from the polynomial, the best one first, until none makes it
;;; smaller
(defun gs-descend (ids p)
  (loop
    (let ((zero (gs-best-zero ids (gs-monomials p))))
      (unless zero (return p))
      (setq p ($expand (sub p zero))))))
;;; the zero of the greatest gain; nil if there is none
(defun gs-best-zero (ids l)
  (let ((most 0) (best nil))
    (when (cdr l)
      (dolist (id ids best)
        (dolist (x (gs-cofactors id l))
          (let* ((zero (mapcar #'(lambda (term) (mul x term)) id))
                 (counts (mapcar #'(lambda (term) (gs-times-in l (gs-monomial term))) zero)))
            (dolist (f (cdr ($unique (gs-list (remove 0 counts)))))
              (let ((gain (gs-taking-gain counts f zero)))
                (when (> gain most)
                  (setq most gain best (mul f (addn zero nil))))))))))))
;;; how many times the monomials l hold a term
(defun gs-times-in (l term)
  (let ((own (assoc (car term) l :test #'alike1))) (if own (div (cdr own) (cdr term)) 0)))
;;; monomials x such that two of x*t1, x*t2, x*t3 occur
(defun gs-cofactors (id l)
  (let ((seen nil) (twice nil))
    (dolist (term id (cdr ($unique (gs-list twice))))
      (let ((r (power term -1)))
        (dolist (m l)
          (let ((x (car (gs-monomial (mul r (car m))))))
            (if (member x seen :test #'alike1) (push x twice) (push x seen))))))))
;;; what is saved by taking f times a zero (three terms) from terms that occur so many times
(defun gs-taking-gain (counts f zero)
  (flet ((size (term n) (if (eql n 0) 0 (gs-term-size (car (gs-monomial term)) n))))
    (loop for n in counts for term in zero sum (- (size term n) (size term (sub n f))))))
