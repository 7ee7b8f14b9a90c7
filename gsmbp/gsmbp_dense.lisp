;;; gsmbp_dense.lisp: two small pieces of dense linear algebra in double precision, for the closing of loops while a scene is derived.
;;; Matrices are Maxima lists of rows of floats. (What runs later is Fortran; this only has to be quick enough.)
(in-package :maxima)

(defun gsmbp-rows (m) (mapcar #'(lambda (r) (coerce (mapcar #'(lambda (x) (coerce x 'double-float)) (cdr r)) 'simple-vector)) (cdr m)))

(defun gsmbp-dot (a b)
  (let ((s 0.0d0))
    (dotimes (i (length a) s) (incf s (* (svref a i) (svref b i))))))

;;; gsmbp__damped(J, phi, mu): -J' (J J' + mu 1)^-1 phi, the shortest damped step towards phi = 0.
(defun $gsmbp__damped (j phi mu)
  (let* ((rows (coerce (gsmbp-rows j) 'simple-vector)) (m (length rows)) (n (length (svref rows 0)))
         (c (make-array (list m m) :initial-element 0.0d0))
         (y (coerce (mapcar #'(lambda (x) (- (coerce x 'double-float))) (cdr phi)) 'simple-vector)) (dx (make-array n :initial-element 0.0d0)))
    (dotimes (i m)
      (do ((k 0 (1+ k))) ((> k i))
        (setf (aref c i k) (+ (gsmbp-dot (svref rows i) (svref rows k)) (if (= i k) (coerce mu 'double-float) 0.0d0)))))
    (dotimes (k m)                      ; Cholesky, in place
      (do ((l 0 (1+ l))) ((>= l k))
        (do ((i k (1+ i))) ((>= i m)) (decf (aref c i k) (* (aref c i l) (aref c k l)))))
      (let ((d (sqrt (max (aref c k k) 1.0d-300))))
        (do ((i k (1+ i))) ((>= i m)) (setf (aref c i k) (/ (aref c i k) d)))))
    (dotimes (k m)
      (setf (svref y k) (/ (svref y k) (aref c k k)))
      (do ((i (1+ k) (1+ i))) ((>= i m)) (decf (svref y i) (* (aref c i k) (svref y k)))))
    (do ((k (1- m) (1- k))) ((< k 0))
      (do ((i (1+ k) (1+ i))) ((>= i m)) (decf (svref y k) (* (aref c i k) (svref y i))))
      (setf (svref y k) (/ (svref y k) (aref c k k))))
    (dotimes (i m) (dotimes (k n) (incf (svref dx k) (* (svref y i) (svref (svref rows i) k)))))
    (cons '(mlist) (coerce dx 'list))))

;;; gsmbp__independent_rows(A, tol): the numbers of the rows that do not depend on those before them: what is left of a row after
;;; orthogonalization is above tol times its size.
(defun $gsmbp__independent_rows (a tol)
  (let ((basis nil) (kept nil) (number 0))
    (dolist (r (gsmbp-rows a))
      (incf number)
      (let ((size (sqrt (gsmbp-dot r r))))
        (dotimes (pass 2)
          (dolist (b basis)
            (let ((s (gsmbp-dot b r)))
              (dotimes (i (length r)) (decf (svref r i) (* s (svref b i)))))))
        (let ((left (sqrt (gsmbp-dot r r))))
          (when (> left (* (coerce tol 'double-float) size))
            (dotimes (i (length r)) (setf (svref r i) (/ (svref r i) left)))
            (push r basis)
            (push number kept)))))
    (cons '(mlist) (nreverse kept))))
