;;; tape/code.lisp: tape code (lists of entries [name, expression, block, number, symbols]) in
;;; Lisp: what tape/differentiate.mac does with every entry.
(in-package :maxima)

(defun gsmbp-entry-name (e) (nth 1 e))
(defun gsmbp-entry-expression (e) (nth 2 e))
(defun gsmbp-entry-block (e) (nth 3 e))
(defun gsmbp-entry-number (e) (nth 4 e))
(defun gsmbp-entry-symbols (e) (cdr (nth 5 e)))

;;; entries of a tape that symbols need, oldest first
(defun $gsmbp__reach_symbols (entry nature symbols constants)
  (let ((seen (make-hash-table :test #'eq)) (found nil) (todo (cdr symbols)))
    (do () ((null todo) (gsmbp-list (sort found #'< :key #'gsmbp-entry-number)))
      (let ((s (pop todo)))
        (unless (gethash s seen)
          (setf (gethash s seen) t)
          (let ((e (gethash s entry)))
            (when (and e (or constants (not (eq (gethash s nature) '$constant))))
              (push e found)
              (dolist (x (gsmbp-entry-symbols e)) (unless (gethash x seen) (push x todo))))))))))

;;; The constants of the tape that code and symbols use, in the order of the tape.
(defun $gsmbp__constants_among (tp codes symbols)
  (let ((seen (make-hash-table :test #'eq)) (found nil))
    (flet ((take (s)
             (unless (gethash s seen)
               (setf (gethash s seen) t)
               (let ((e (gethash s (gsmbp-entries tp))))
                 (when (and e (eq (gethash s (gsmbp-nature tp)) '$constant)) (push e found))))))
      (mapc #'take (cdr symbols))
      (dolist (code (cdr codes)) (dolist (e (cdr code)) (mapc #'take (gsmbp-entry-symbols e)))))
    (gsmbp-list (mapcar #'gsmbp-entry-name (sort found #'< :key #'gsmbp-entry-number)))))

;;; ------------------------------------------------------------------------------------ derivatives

;;; Rates of the outputs on the tape of the namer nm, from those of symbols: seeds [symbol = rate,
;;; ...]; code: the entries that they need.
(defun $gsmbp__code_diff (nm code outputs seeds)
  (let ((h (make-hash-table :test #'eq)) (trig (nth 6 (nth 3 nm))))
    (dolist (s (cdr seeds)) (setf (gethash (cadr s) h) (caddr s)))
    (dolist (e (cdr code))
      (when (dolist (s (gsmbp-entry-symbols e)) (when (gethash s h) (return t)))
        (let ((d (gsmbp-name-one nm (gsmbp-entry-rate h e (gethash (gsmbp-entry-name e) trig)) "")))
          (unless (eql d 0) (setf (gethash (gsmbp-entry-name e) h) d)))))
    (gsmbp-list (mapcar #'(lambda (x) (gsmbp-name-one nm ($gsmbp__rate h x) "")) (cdr outputs)))))

;;; a sine is differentiated through its partner: trig is [partner, angle, sin or cos], or false
(defun gsmbp-entry-rate (h e trig)
  (if (null trig) ($gsmbp__rate h (gsmbp-entry-expression e))
    (let ((r (gsmbp-times (cadr trig) ($gsmbp__rate h (cadr (gsmbp-entry-expression e))))))
      (if (eq (cadddr trig) '%sin) r (gsmbp-minus r)))))

;;; rate of an expression from the rates in h of its symbols
(defun $gsmbp__rate (h e)
  (cond ((symbolp e) (or (gethash e h) 0))
        ((gsmbp-name-or-number-p e) 0)
        ((gsmbp-sum-p e) (gsmbp-plus (mapcar #'(lambda (x) ($gsmbp__rate h x)) (cdr e))))
        ((gsmbp-product-p e) (gsmbp-product-rate h (cdr e)))
        ((and (gsmbp-power-p e) (mnump (caddr e)))
         (let ((r ($gsmbp__rate h (cadr e))))
           (if (eql r 0)
               0
               (muln (list (caddr e) (power (cadr e) (gsmbp-difference (caddr e) 1)) r) t))))
        ; Maxima writes sech, which Fortran has not
        ((eq (caar e) '%tanh) (gsmbp-times (sub 1 (power e 2)) ($gsmbp__rate h (cadr e))))
        (t (gsmbp-function-rate h ($op e) (cdr e)))))

;;; rate of any other function: Maxima's derivative with respect to each argument, through symbols
;;; that nothing else has
(defun gsmbp-function-rate (h f arguments)
  (let* ((symbols (loop for k from 1 to (length arguments) collect ($concat '$gsmbp__arg k)))
         (value (mfuncall '$apply f (gsmbp-list symbols)))
         (places (gsmbp-list
                   (mapcar #'(lambda (s a) (list '(mequal simp) s a)) symbols arguments))))
    (gsmbp-plus
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
        ($gsmbp__rate h a)
        unless
        (eql r 0)
        collect
        (mul r ($substitute places ($diff value s)))))))

(defun gsmbp-product-rate (h factors)
  (let ((terms nil))
    (dolist (f factors (gsmbp-plus (nreverse terms)))
      (let ((r ($gsmbp__rate h f)))
        (unless (eql r 0)
          (push (gsmbp-times r (gsmbp-multiply (remove f factors :test #'eq :count 1))) terms))))))

;;; ------------------------------------------------------------------------------------------- tidy

;;; Code and outputs with every name that is used once (sines and cosines apart) written where it is
;;; used: [[[name, expression, block], ...], outputs].
(defun $gsmbp__write_once (tp code outputs)
  (let ((uses (make-hash-table :test #'eq)) (inline (make-hash-table :test #'eq)) (trig (nth 6 tp))
        (kept nil))
    (dolist (e (cdr code))
      (gsmbp-count-uses uses (gsmbp-entry-expression e) (gsmbp-entry-symbols e)))
    (dolist (x (cdr outputs)) (gsmbp-count-uses uses x (cdr ($gsmbp__symbols x))))
    (dolist (e (cdr code))
      (let ((x (gsmbp-put-in inline (gsmbp-entry-expression e) (gsmbp-entry-symbols e)))
            (name (gsmbp-entry-name e)))
        (if (and (eql (gethash name uses) 1) (not (gethash name trig)) (<= (gsmbp-size x) 24))
            (setf (gethash name inline) x)
            (push (list name x (gsmbp-entry-block e)) kept))))
    (setq outputs
          (mapcar #'(lambda (x) (gsmbp-put-in inline x (cdr ($gsmbp__symbols x)))) (cdr outputs)))
    (gsmbp-list (list (gsmbp-list (gsmbp-still-used kept outputs)) (gsmbp-list outputs)))))

;;; the entries (newest first) that the outputs still use, oldest first: what was put in may have
;;; cancelled
(defun gsmbp-still-used (kept outputs)
  (let ((used (make-hash-table :test #'eq)) (l nil))
    (flet ((use (x) (dolist (s (cdr ($gsmbp__symbols x))) (setf (gethash s used) t))))
      (mapc #'use outputs)
      (dolist (e kept l)
        (when (gethash (car e) used)
          (use (cadr e))
          (push (gsmbp-list e) l))))))

;;; e with those of its symbols (given) replaced that have something to be put in
(defun gsmbp-put-in (inline e symbols)
  (if (dolist (s symbols) (when (gethash s inline) (return t))) ($gsmbp__replace inline e) e))

;;; operands of an entry are names, each once; a power or a quotient counts as two uses, a root as
;;; one
(defun gsmbp-count-uses (uses e symbols)
  (let ((k (if (and (consp e)
                    (member (caar e) '(mexpt mtimes))
                    (member (caar (nformat e)) '(mexpt mquotient)))
               2
               1)))
    (dolist (s symbols) (setf (gethash s uses) (+ k (gethash s uses 0))))))

;;; number of nodes as Maxima displays an expression
(defun gsmbp-size (e)
  (if (or (atom e) (eq (caar e) 'rat)) 1
    (let ((f (if (member (caar e) '(mtimes mexpt)) (nformat e) e)) (n 1))
      (if (atom f) 1 (dolist (x (cdr f) n) (incf n (gsmbp-size x)))))))

;;; ------------------------------------------------------------------------------------------ sines

;;; The code with the sine and cosine of a sum of two angles made of those of both where the code
;;; has these: three products and sums each instead of a call. An angle of which the code has one of
;;; the two gets the other: one call gives both.
(defun $gsmbp__fewer_sines (tp code)
  (let ((trig (nth 6 tp)) (known (make-hash-table :test #'eq)) (sums (make-hash-table :test #'eq))
        (there (make-hash-table :test #'eq)) (more nil) (made nil))
    (dolist (e (cdr code))
      (let* ((name (gsmbp-entry-name e)) (x (gsmbp-entry-expression e)) (w (gethash name trig)))
        (cond (w (setf (gethash name there) t)
                 (when (symbolp (cadr x))
                   (setf (gethash (cadr x) known)
                         (if (eq (cadddr w) '%sin) (list name (cadr w)) (list (cadr w) name)))))
              ((gsmbp-sum-p x) (setf (gethash name sums) x)))))
    (dolist (e (cdr code) (gsmbp-list (append more (nreverse made))))
      (let* ((w (gethash (gsmbp-entry-name e) trig))
             (sc (if w (gsmbp-sum-of-known known sums (cadr (gsmbp-entry-expression e))))))
        (cond ((null sc) (push e made))
              (t (dolist (s sc)
                   (unless (gethash s there)
                     (setf (gethash s there) t)
                     (push (gethash s (gsmbp-entries tp)) more)))
                 (destructuring-bind (sa ca sb cb) sc
                   (let ((x (if (eq (cadddr w) '%sin)
                                (gsmbp-sum (gsmbp-times sa cb) (gsmbp-times ca sb))
                                (gsmbp-difference (gsmbp-times ca cb) (gsmbp-times sa sb)))))
                     (push (gsmbp-list
                             (list (gsmbp-entry-name e)
                                   x
                                   (gsmbp-entry-block e)
                                   (gsmbp-entry-number e)
                                   ($gsmbp__symbols x))) made)))))))))
;;; (sine cosine sine cosine) of the two angles whose sum `angle` is, or nil
(defun gsmbp-sum-of-known (known sums angle)
  (let ((s (and (symbolp angle) (gethash angle sums))))
    (when (and s (null (cdddr s)))
      (destructuring-bind (a b) (cdr ($args s))
        (when (and (symbolp a) (symbolp b))
          (let ((x (gethash a known)) (y (gethash b known))) (when (and x y) (append x y))))))))

;;; true if one of the code sets a pair at once
(defun $gsmbp__sets_pairs (code) (and (find-if #'(lambda (e) ($listp (cadr e))) (cdr code)) t))

;;; the code as it is written: what the table `known` holds put in for names
(defun $gsmbp__written_code (known code)
  (gsmbp-list
    (mapcar #'(lambda (e)
                (gsmbp-list
                  (list (or (gethash (cadr e) known) (cadr e))
                        ($gsmbp__replace known (caddr e))
                        (cadddr e)))) (cdr code))))
