;;; tape/code.lisp: tape code (lists of entries [name, expression, block, number, symbols]) in
;;; Lisp: what tape/differentiate.mac does with every entry.
(in-package :maxima)

(defun gs-entry-name (e) (nth 1 e))
(defun gs-entry-expression (e) (nth 2 e))
(defun gs-entry-block (e) (nth 3 e))
(defun gs-entry-number (e) (nth 4 e))
(defun gs-entry-symbols (e) (cdr (nth 5 e)))
(defun $gs__entry_block (e) (gs-entry-block e))
(defun $gs__entry_symbols (e) (nth 5 e))

;;; Entries [name, expression, block, number, symbols] that a list of expressions needs, oldest
;;; first. Constant entries are included only if constants is true.
(defun $gs__reach (tp outputs constants)
  ($gs__reach_symbols (gs-entries tp) (gs-nature tp) ($gs__symbols outputs) constants))
(defun $gs__reach_symbols (entry nature symbols constants)
  (let ((seen (make-hash-table :test #'eq)) (found nil) (todo (cdr symbols)))
    (do () ((null todo) (gs-list (stable-sort found #'< :key #'gs-entry-number)))
      (let ((s (pop todo)))
        (unless (gethash s seen)
          (setf (gethash s seen) t)
          (let ((e (gethash s entry)))
            (when (and e (or constants (not (eq (gethash s nature) '$constant))))
              (push e found)
              (dolist (x (gs-entry-symbols e)) (unless (gethash x seen) (push x todo))))))))))

;;; Do the outputs depend on one of these symbols?
(defun $gs__reaches (tp outputs symbols)
  (let ((entry (gs-entries tp)) (nature (gs-nature tp)) (seen (make-hash-table :test #'eq))
        (todo (copy-list (cdr ($gs__symbols outputs)))))
    (do () ((null todo) nil)
      (let ((s (pop todo)))
        (when (member s (cdr symbols) :test #'eq) (return t))
        (unless (gethash s seen)
          (setf (gethash s seen) t)
          (let ((e (gethash s entry)))
            (unless (or (null e) (eq (gethash s nature) '$constant))
              (setq todo (append (gs-entry-symbols e) todo)))))))))

;;; The constants of the tape that code and symbols use, in the order of the tape.
(defun $gs__constants_among (tp codes symbols)
  (let ((seen (make-hash-table :test #'eq)) (found nil))
    (flet ((take (s)
             (unless (gethash s seen)
               (setf (gethash s seen) t)
               (let ((e (gethash s (gs-entries tp))))
                 (when (and e (eq (gethash s (gs-nature tp)) '$constant)) (push e found))))))
      (mapc #'take (cdr symbols))
      (dolist (code (cdr codes)) (dolist (e (cdr code)) (mapc #'take (gs-entry-symbols e)))))
    (gs-list (mapcar #'gs-entry-name (stable-sort found #'< :key #'gs-entry-number)))))

;;; The constants by which PRE comes to those that routines use, without these and the known ones.
(defun $gs__helpers_of (tp constants known)
  (let ((used (make-hash-table :test #'eq)))
    (dolist (s (cdr constants)) (setf (gethash s used) t))
    (gs-list
      (remove-if #'(lambda (s) (or (gethash s used) (gethash s known)))
                 (mapcar #'gs-entry-name (cdr ($gs__reach tp constants t)))))))

;;; ------------------------------------------------------------------------------------ derivatives

;;; Rates of the outputs on the tape of the namer nm, from those of symbols: seeds [symbol = rate,
;;; ...]; code: the entries that they need.
(defun $gs__code_diff (nm code outputs seeds)
  (let ((h (make-hash-table :test #'eq)) (trig (nth 6 (nth 3 nm))))
    (dolist (s (cdr seeds)) (setf (gethash (cadr s) h) (caddr s)))
    (dolist (e (cdr code))
      (when (dolist (s (gs-entry-symbols e)) (when (gethash s h) (return t)))
        (let ((d (gs-name-one nm (gs-entry-rate h e (gethash (gs-entry-name e) trig)) "")))
          (gs-mark-rate (nth 3 nm) d (gs-entry-name e) (cdr seeds))
          (unless (eql d 0) (setf (gethash (gs-entry-name e) h) d)))))
    (gs-list (mapcar #'(lambda (x) (gs-name-one nm ($gs__rate h x) "")) (cdr outputs)))))

;;; The other way round: derivatives of the sum of the outputs times their weights by the wanted
;;; symbols, from the last entry of code to the first: a list of names. Their cost does not grow
;;; with the number of symbols.
(defun $gs__code_reverse (nm code outputs weights wanted)
  (let ((terms (make-hash-table :test #'eq)) (trig (nth 6 (nth 3 nm))))
    (gs-rec ((partial (s rate)
               (let ((h (make-hash-table :test #'eq))) (setf (gethash s h) 1) (funcall rate h)))
             (add (s weight rate)
               (let ((d (partial s rate)))
                 (unless (eql d 0) (push (gs-times weight d) (gethash s terms)))))
             (total (s)
               (let ((l (gethash s terms))) (if l (gs-name-one nm (gs-plus (reverse l)) "bar") 0))))
      (loop for e in (cdr outputs) for w in (cdr weights)
            do (dolist (s (cdr ($gs__symbols e))) (add s w #'(lambda (h) ($gs__rate h e)))))
      (dolist (e (reverse (cdr code)))
        (let ((b (total (gs-entry-name e))))
          (unless (eql b 0)
            (dolist (s (gs-entry-symbols e))
              (add s b #'(lambda (h) (gs-entry-rate h e (gethash (gs-entry-name e) trig))))))))
      (gs-list (mapcar #'total (cdr wanted))))))

;;; a sine is differentiated through its partner: trig is [partner, angle, sin or cos], or false
(defun gs-entry-rate (h e trig)
  (if (null trig) ($gs__rate h (gs-entry-expression e))
    (let ((r (gs-times (cadr trig) ($gs__rate h (cadr (gs-entry-expression e))))))
      (if (eq (cadddr trig) '%sin) r (gs-minus r)))))

;;; rate of an expression from the rates in h of its symbols
(defun $gs__rate (h e)
  (cond ((symbolp e) (or (gethash e h) 0))
        ((gs-name-or-number-p e) 0)
        ((gs-sum-p e) (gs-plus (mapcar #'(lambda (x) ($gs__rate h x)) (cdr e))))
        ((gs-product-p e) (gs-product-rate h (cdr e)))
        ((and (gs-power-p e) (mnump (caddr e)))
         (let ((r ($gs__rate h (cadr e))))
           (if (eql r 0)
               0
               (muln (list (caddr e) (power (cadr e) (gs-difference (caddr e) 1)) r) t))))
        ; Maxima writes sech, which Fortran has not
        ((eq (caar e) '%tanh) (gs-times (sub 1 (power e 2)) ($gs__rate h (cadr e))))
        ; Maxima writes x/|x|, which has no value at 0
        ((eq (caar e) 'mabs) (gs-times (take '(%signum) (cadr e)) ($gs__rate h (cadr e))))
        ((member (caar e) '(%signum $round %round $gs__floor $gs__after)) 0)
        ((member (caar e) '($max %max $min %min)) (gs-greatest-rate h (caar e) (cdr e)))
        (t (gs-function-rate h ($op e) (cdr e)))))

;;; of max(x, y, ...), min(x, y, ...): the one that it is decides
(defun gs-greatest-rate (h f arguments)
  (if (null (cdr arguments)) ($gs__rate h (car arguments))
    (let* ((x (car arguments)) (y (simplifya (cons (list f) (cdr arguments)) t))
           (a ($gs__rate h x)) (b (gs-greatest-rate h f (cdr arguments)))
           (side (take '(%signum) (gs-difference x y)))
           (half (list '(rat simp) 1 2)))
      (if (member f '($min %min)) (setq side (gs-minus side)))
      (gs-times half (gs-plus (list a b (gs-times side (gs-difference a b))))))))

;;; derivative of an expression by the coordinate q; atoms [s, c, angle]: s and c stand for the sine
;;; and cosine of the angle, [[coordinate, integer], ...]
(defun $gs__angle_rate (atoms e q)
  (let ((h (make-hash-table :test #'eq)))
    (setf (gethash q h) 1)
    (loop for (nil s c angle) in (cdr atoms)
          do (let ((n (caddr (find q (cdr angle) :key #'cadr :test #'eq))))
               (when n
                 (setf (gethash s h) (gs-times n c) (gethash c h) (gs-times (- n) s)))))
    ($gs__rate h e)))

;;; |x| and its sign under names of their own while Maxima differentiates (gs__derivative); not by
;;; gradef, which would stand in the session's list of gradefs
(defprop $gs__modulus ((x) (($gs__sign) x)) grad)
(defprop $gs__sign ((x) 0) grad)

;;; rate of any other function: Maxima's derivative with respect to each argument, through symbols
;;; that nothing else has
(defun gs-function-rate (h f arguments)
  (let* ((symbols (loop for k from 1 to (length arguments) collect ($concat '$gs__arg k)))
         (value (mfuncall '$apply f (gs-list symbols)))
         (places (gs-list
                   (mapcar #'(lambda (s a) (list '(mequal simp) s a)) symbols arguments))))
    (gs-plus
      (loop
        for
        a
        in
        arguments
        for
        s
        in
        symbols
        for
        r
        =
        ($gs__rate h a)
        unless
        (eql r 0)
        collect
        (mul r ($substitute places ($diff value s)))))))

(defun gs-product-rate (h factors)
  (let ((terms nil))
    (dolist (f factors (gs-plus (nreverse terms)))
      (let ((r ($gs__rate h f)))
        (unless (eql r 0)
          (push (gs-times r (gs-multiply (remove f factors :test #'eq :count 1))) terms))))))

;;; ------------------------------------------------------------------------------------------- tidy

;;; Code and outputs with every name that is used once (sines and cosines apart) written where it is
;;; used: [[[name, expression, block], ...], outputs].
(defun $gs__write_once (tp code outputs)
  (let ((uses (make-hash-table :test #'eq)) (inline (make-hash-table :test #'eq)) (trig (nth 6 tp))
        (kept nil))
    (dolist (e (cdr code))
      (gs-count-uses uses (gs-entry-expression e) (gs-entry-symbols e)))
    (dolist (x (cdr outputs)) (gs-count-uses uses x (cdr ($gs__symbols x))))
    (dolist (e (cdr code))
      (let ((x (gs-put-in inline (gs-entry-expression e) (gs-entry-symbols e)))
            (name (gs-entry-name e)))
        (if (and (eql (gethash name uses) 1) (not (gethash name trig)) (<= (gs-size x) 24))
            (setf (gethash name inline) x)
            (push (list name x (gs-entry-block e)) kept))))
    (setq outputs
          (mapcar #'(lambda (x) (gs-put-in inline x (cdr ($gs__symbols x)))) (cdr outputs)))
    (gs-list (list (gs-list (gs-still-used kept outputs)) (gs-list outputs)))))

;;; the entries (newest first) that the outputs still use, oldest first: what was put in may have
;;; cancelled
(defun gs-still-used (kept outputs)
  (let ((used (make-hash-table :test #'eq)) (l nil))
    (flet ((use (x) (dolist (s (cdr ($gs__symbols x))) (setf (gethash s used) t))))
      (mapc #'use outputs)
      (dolist (e kept l)
        (when (gethash (car e) used)
          (use (cadr e))
          (push (gs-list e) l))))))

;;; e with those of its symbols (given) replaced that have something to be put in
(defun gs-put-in (inline e symbols)
  (if (dolist (s symbols) (when (gethash s inline) (return t))) ($gs__replace inline e) e))

;;; operands of an entry are names, each once; a power or a quotient counts as two uses, a root as
;;; one
(defun gs-count-uses (uses e symbols)
  (let ((k (if (and (consp e)
                    (member (caar e) '(mexpt mtimes))
                    (member (caar (nformat e)) '(mexpt mquotient)))
               2
               1)))
    (dolist (s symbols) (setf (gethash s uses) (+ k (gethash s uses 0))))))

;;; number of nodes as Maxima displays an expression
(defun gs-size (e)
  (if (or (atom e) (eq (caar e) 'rat)) 1
    (let ((f (if (member (caar e) '(mtimes mexpt)) (nformat e) e)) (n 1))
      (if (atom f) 1 (dolist (x (cdr f) n) (incf n (gs-size x)))))))

;;; ------------------------------------------------------------------------------------------ sines

;;; The code with the sine and cosine of a sum of two angles made of those of both where the code
;;; has these: three products and sums each instead of a call. An angle of which the code has one of
;;; the two gets the other: one call gives both.
(defun $gs__fewer_sines (tp code)
  (let ((trig (nth 6 tp)) (known (make-hash-table :test #'eq)) (sums (make-hash-table :test #'eq))
        (there (make-hash-table :test #'eq)) (more nil) (made nil))
    (dolist (e (cdr code))
      (let* ((name (gs-entry-name e)) (x (gs-entry-expression e)) (w (gethash name trig)))
        (cond (w (setf (gethash name there) t)
                 (when (symbolp (cadr x))
                   (setf (gethash (cadr x) known)
                         (if (eq (cadddr w) '%sin) (list name (cadr w)) (list (cadr w) name)))))
              ((gs-sum-p x) (setf (gethash name sums) x)))))
    (dolist (e (cdr code) (gs-list (append more (nreverse made))))
      (let* ((w (gethash (gs-entry-name e) trig))
             (sc (if w (gs-sum-of-known known sums (cadr (gs-entry-expression e))))))
        (cond ((null sc) (push e made))
              (t (dolist (s sc)
                   (unless (gethash s there)
                     (setf (gethash s there) t)
                     (push (gethash s (gs-entries tp)) more)))
                 (destructuring-bind (sa ca sb cb) sc
                   (let ((x (if (eq (cadddr w) '%sin)
                                (gs-sum (gs-times sa cb) (gs-times ca sb))
                                (gs-difference (gs-times ca cb) (gs-times sa sb)))))
                     (push (gs-list
                             (list (gs-entry-name e)
                                   x
                                   (gs-entry-block e)
                                   (gs-entry-number e)
                                   ($gs__symbols x))) made)))))))))
;;; (sine cosine sine cosine) of the two angles whose sum `angle` is, or nil
(defun gs-sum-of-known (known sums angle)
  (let ((s (and (symbolp angle) (gethash angle sums))))
    (when (and s (null (cdddr s)))
      (destructuring-bind (a b) (cdr ($args s))
        (when (and (symbolp a) (symbolp b))
          (let ((x (gethash a known)) (y (gethash b known))) (when (and x y) (append x y))))))))

;;; true if one of the code sets a pair at once
(defun $gs__sets_pairs (code) (loop for e in (cdr code) thereis (and ($listp (cadr e)) t)))

;;; the code as it is written: what the table `known` holds put in for names
(defun $gs__written_code (known code)
  (gs-list
    (mapcar #'(lambda (e)
                (gs-list
                  (list (or (gethash (cadr e) known) (cadr e))
                        ($gs__replace known (caddr e))
                        (cadddr e)))) (cdr code))))
