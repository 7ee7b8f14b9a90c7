;;; kernel/lists.lisp: small functions on lists and exact numbers that a derivation calls thousands
;;; of times (see kernel/errors.mac), in Lisp.
(in-package :maxima)

;;; labels whose functions are not inlined: GCL 2.7.1 compiles inlined recursive ones wrongly (they
;;; return without having run)
(defmacro gs-rec (functions &body body)
  `(labels ,functions (declare (notinline ,@(mapcar #'car functions))) ,@body))

;;; the lists of a list, one behind the other; the sum of a list of terms
(defun $gs__flat (l)
  (let ((all nil))
    (dolist (x (cdr l) (gs-list (nreverse all)))
      (unless ($listp x) (merror "a list of lists is expected; found: ~M" x))
      (setq all (revappend (cdr x) all)))))
(defun $gs__sum (l) (addn (cdr l) nil))

;;; [the first n of l, the others]; the nthcdr of GCL is recursive, and with it Maxima's firstn and
;;; rest: they fail beyond some thousand elements
(defun $gs__cut_at (l n)
  (let ((front nil) (back (cdr l)))
    (dotimes (k n) (push (pop back) front))
    (gs-list (list (gs-list (nreverse front)) (gs-list back)))))

;;; f of the parts of every row, gs__each(lambda([name, unit], ...), [[q1, "rad"], ...]); and the
;;; rows of whose parts f is true
(defun $gs__each (f rows) (gs-list (mapcar #'(lambda (row) (gs-of-parts f row)) (cdr rows))))
(defun $gs__rows_that (f rows)
  (gs-list (remove-if-not #'(lambda (row) (definitely-so (gs-of-parts f row))) (cdr rows))))
(defun gs-of-parts (f row) (mapply1 f (cdr row) f row))

(defun $gs__zero_matrix () (gs-list (loop repeat 3 collect (gs-list (list 0 0 0)))))
(defun $gs__identity ()
  (gs-list (list (gs-list (list 1 0 0)) (gs-list (list 0 1 0)) (gs-list (list 0 0 1)))))

;;; position of the first element of l that is x, or 0
(defun $gs__position (x l)
  (let ((k 0)) (dolist (y (cdr l) 0) (incf k) (when (alike1 x y) (return k)))))

;;; the first row of a table (a list of lists) that begins with the symbol key, else false
(defun $gs__row_of (table key) (car (member key (cdr table) :key #'cadr)))

;;; true of a = b
(defun $gs__is_equation (e) (and (consp e) (eq (caar e) 'mequal)))
;;; symbol = value of the rows [symbol, value, unit] whose value is not false
(defun $gs__known (parameters)
  (gs-list (loop for (nil symbol value) in (cdr parameters)
                 when value collect (list '(mequal simp) symbol value))))

;;; ---------------------------------------------------------------------------------- exact numbers

;;; The rational of the fewest decimal digits that rounds to the double x: 0.1 => 1/10, 1.0e-4 =>
;;; 1/10000. Worked out in exact arithmetic (the printer of GCL is not exact): x = 0.1 + 0.2 =>
;;; 30000000000000004/10^17.
(defun gs-decimal (x)
  (if (zerop x)
      0
      (multiple-value-bind (m e) (integer-decode-float (abs x))
        (let* ((r (* m (expt 2 e))) (n (+ (integer-length m) e -1)) (h (gs-half-ulp r n))
               (d (gs-log10 r n)))
          (do ((k 0 (1+ k)))
              (nil)
            (let* ((c (* (round (* r (expt 10 (- k d)))) (expt 10 (- d k)))) (apart (abs (- c r))))
              (when (or (< apart h) (and (= apart h) (evenp (/ r (* 2 h)))))
                (return (if (minusp x) (- c) c)))))))))
;;; half the width of the numbers that round to r, n = floor(log2(r))
(defun gs-half-ulp (r n) (expt 2 (- (max (- n 52) -1074) (if (= r (expt 2 n)) 2 1))))
;;; floor(log10(r))
(defun gs-log10 (r n)
  (let ((d (floor (* n 30103) 100000)))
    (do () ((> (expt 10 (1+ d)) r)) (incf d))
    (do () ((<= (expt 10 d) r) d) (decf d))))
(defun gs-inexact-p (e)
  (cond ((atom e) (floatp e))
        ((member (caar e) '(bigfloat mrat)) t)
        (t (loop for x in (cdr e) thereis (gs-inexact-p x)))))

;;; ------------------------------------------------------------------------------------------ texts

(defun $gs__print_lines (stream lines)
  (dolist (l (cdr lines)) (write-string l stream) (terpri stream)))

;;; true if the list of texts holds s, whatever the case
(defun $gs__holds_text (texts s) (and (member s (cdr texts) :test #'string-equal) t))

;;; The first two of the names (records whose first field is the name) that are the same when case
;;; is ignored, or false
(defun $gs__first_collision (names)
  (let ((known (make-hash-table)))
    (dolist (x (cdr names))
      (let* ((text ($sconcat (cadr x))) (key (gs-text-key text))
             (old (assoc text (gethash key known) :test #'string-equal)))
        (when old (return (gs-list (list (cdr old) x))))
        (push (cons text x) (gethash key known))))))

;;; [c, e] of an expression c*e with a number c in front, [1, e] of any other
(defun $gs__number_apart (e)
  (gs-list (if (and (consp e) (eq (caar e) 'mtimes) (mnump (cadr e)))
             (list (cadr e) (gs-multiply (cddr e)))
             (list 1 e))))

;;; what a floating point number has behind the point
(defun $gs__fraction (x) (- x (floor x)))

(defun gs-list (l) (cons '(mlist simp) l))

(defun gs-multiply (l) (if (cdr l) (muln l t) (if l (car l) 1)))

;;; The table of the operations. Lisp's own hash of a list looks at its first few conses only, so
;;; that sums would share a place.
(defconstant gs-key-size 8388593)

;;; A table of texts: number made of the text (case does not count) -> list of (text . value).
;;; Lisp's own hash of a text lets thousands share a place.
(defun gs-text-key (s)
  (let ((k 0))
    (dotimes (i (length s) k)
      (setq k (mod (+ (* 31 k) (char-code (char-downcase (char s i)))) gs-key-size)))))

(defun gs-sum-p (e) (and (consp e) (eq (caar e) 'mplus)))
(defun gs-product-p (e) (and (consp e) (eq (caar e) 'mtimes)))
(defun gs-power-p (e) (and (consp e) (eq (caar e) 'mexpt)))

(defun gs-text (&rest parts) (apply #'concatenate 'string parts))

(defun gs-joined (parts between)
  (if (and (string= between "") (null (nthcdr 40 parts))) (apply #'concatenate 'string parts)
    (with-output-to-string (s)
      (do ((l parts (cdr l))) ((null l))
        (write-string (car l) s)
        (when (cdr l) (write-string between s))))))

;;; letters, digits and _ only, a letter first, at most 26 characters (a rename needs five)
(defun gs-letter-p (c) (and (< (char-code c) 128) (alpha-char-p c)))

(defun gs-word-character-p (c) (or (gs-letter-p c) (digit-char-p c) (char= c #\_)))

(defun $gs__is_fit (s)
  (and (<= 1 (length s) 24) (gs-letter-p (char s 0)) (every #'gs-word-character-p s)))
