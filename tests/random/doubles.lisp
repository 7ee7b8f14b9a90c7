;; doubles.lisp: a tape evaluated in double precision.
;; gs__doubles(entries, names, values, outputs): values of the outputs (expressions of tape
;; symbols) where the symbols `names` have the `values` (exact numbers); entries as gs__reach
;; gives them, oldest first. A list of doubles.
(in-package :maxima)

(defvar *doubles* (make-hash-table :test #'eq))

(defun doubles-number (x)
  (cond ((numberp x) (float x 1d0))
        ((eq (caar x) 'rat) (float (/ (cadr x) (caddr x)) 1d0))
        (t (merror "gs__doubles: not a number: ~M" x))))

(defun doubles-power (b e)
  (cond ((and (integerp e) (< 0 e 9)) (let ((r b)) (dotimes (i (1- e) r) (setq r (* r b)))))
        ((and (integerp e) (< -9 e 0)) (/ 1d0 (doubles-power b (- e))))
        ((and (consp e) (eq (caar e) 'rat) (= (caddr e) 2))
         (let ((r (sqrt b)) (n (cadr e))) (if (= n 1) r (if (= n -1) (/ 1d0 r) (expt r n)))))
        (t (expt b (doubles-value e)))))

(defun doubles-value (e)
  (cond ((numberp e) (float e 1d0))
        ((symbolp e)
         (or (gethash e *doubles*)
             (case e ($%pi pi) (t (merror "gs__doubles: no value: ~M" e)))))
        (t (case (caar e)
             (mplus (let ((s (doubles-value (cadr e))))
                      (dolist (x (cddr e) s) (setq s (+ s (doubles-value x))))))
             (mtimes (let ((s (doubles-value (cadr e))))
                       (dolist (x (cddr e) s) (setq s (* s (doubles-value x))))))
             (rat (float (/ (cadr e) (caddr e)) 1d0))
             (mexpt (doubles-power (doubles-value (cadr e)) (caddr e)))
             (%sin (sin (doubles-value (cadr e))))
             (%cos (cos (doubles-value (cadr e))))
             ((%atan $atan) (atan (doubles-value (cadr e))))
             ((%atan2 $atan2) (atan (doubles-value (cadr e)) (doubles-value (caddr e))))
             (%sqrt (sqrt (doubles-value (cadr e))))
             (mabs (abs (doubles-value (cadr e))))
             (mminus (- (doubles-value (cadr e))))
             (mquotient (/ (doubles-value (cadr e)) (doubles-value (caddr e))))
             (t (merror "gs__doubles: cannot evaluate: ~M" e))))))

(defun $gs__doubles (entries names values outputs)
  (clrhash *doubles*)
  (mapc #'(lambda (s v) (setf (gethash s *doubles*) (doubles-number v))) (cdr names) (cdr values))
  (dolist (e (cdr entries))
    (unless (gethash (cadr e) *doubles*)
      (setf (gethash (cadr e) *doubles*) (doubles-value (caddr e)))))
  (cons '(mlist simp) (mapcar #'doubles-value (cdr outputs))))

;; a double without rounding: mantissa and exponent of two
(defun $gs__print_double (stream x)
  (multiple-value-bind (m e s) (integer-decode-float x) (format stream "~d ~d~%" (* s m) e)))

;; gs__solved_doubles(n, m, numbers, at): accelerations and multipliers of [M, -H'; H, 0] x =
;; [-bias; gamma]; the numbers begin with M by rows and bias, H by rows and gamma begin at number
;; `at`. false if a pivot is small.
(defun doubles-system (n m l at)
  (let* ((k (+ n m)) (v (coerce l 'vector)) (a (make-array (list k (1+ k)) :initial-element 0d0)))
    (dotimes (i n) (dotimes (j n) (setf (aref a i j) (aref v (+ (* i n) j)))))
    (dotimes (i n) (setf (aref a i k) (- (aref v (+ (* n n) i)))))
    (dotimes (r m)
      (dotimes (j n)
        (let ((h (aref v (+ at (* r n) j))))
          (setf (aref a (+ n r) j) h (aref a j (+ n r)) (- h))))
      (setf (aref a (+ n r) k) (aref v (+ at (* m n) r))))
    a))

(defun doubles-solve (a k)
  (let ((x (make-array k)))
    (dotimes (c k)
      (let ((p c))
        (do ((i c (1+ i))) ((= i k)) (when (> (abs (aref a i c)) (abs (aref a p c))) (setq p i)))
        (when (< (abs (aref a p c)) 1d-9) (return-from doubles-solve nil))
        (do ((j c (1+ j))) ((> j k)) (rotatef (aref a p j) (aref a c j)))
        (do ((i (1+ c) (1+ i)))
            ((= i k))
          (let ((f (/ (aref a i c) (aref a c c))))
            (unless (= f 0d0)
              (do ((j c (1+ j))) ((> j k)) (decf (aref a i j) (* f (aref a c j)))))))))
    (do ((i (1- k) (1- i)))
        ((< i 0) (coerce x 'list))
      (let ((s (aref a i k)))
        (do ((j (1+ i) (1+ j))) ((= j k)) (decf s (* (aref a i j) (aref x j))))
        (setf (aref x i) (/ s (aref a i i)))))))

(defun $gs__solved_doubles (n m l at)
  (let ((x (doubles-solve (doubles-system n m (cdr l) at) (+ n m))))
    (and x (cons '(mlist simp) x))))

(mapc #'compile
      '(doubles-number doubles-power doubles-value doubles-system doubles-solve $gs__doubles))
