;;; kernel/linear_algebra.lisp: small pieces of linear algebra, for the rank of constraints and the
;;; closing of loops while a scene is derived. Matrices are Maxima lists of rows. (What runs later
;;; is Fortran; this only has to be quick enough.)
(in-package :maxima)

(defun gs-real (x)                   ; the root of a coordinate may be imaginary, far from the start
  (if (realp x)
      (coerce x 'double-float)
      ($gs__raise "gsmbp: the constraints are not real at a position near the start")))

(defun gs-rows (m)
  (mapcar #'(lambda (r) (coerce (mapcar #'gs-real (cdr r)) 'simple-vector)) (cdr m)))

(defun gs-dot (a b)
  (let ((s 0.0d0))
    (dotimes (i (length a) s) (incf s (* (svref a i) (svref b i))))))

;;; gs__damped(J, phi, mu): -J' (J J' + mu 1)^-1 phi, the shortest damped step towards phi = 0.
(defun $gs__damped (j phi mu)
  (let* ((rows (coerce (gs-rows j) 'simple-vector)) (m (length rows)) (n (length (svref rows 0)))
         (c (make-array (list m m) :initial-element 0.0d0))
         (y (coerce (mapcar #'(lambda (x) (- (gs-real x))) (cdr phi)) 'simple-vector))
         (dx (make-array n :initial-element 0.0d0)))
    (dotimes (i m)
      (do ((k 0 (1+ k)))
          ((> k i))
        (setf (aref c i k)
              (+ (gs-dot (svref rows i) (svref rows k))
                 (if (= i k) (coerce mu 'double-float) 0.0d0)))))
    (dotimes (k m)  ; Cholesky, in place
      (do ((l 0 (1+ l)))
          ((>= l k))
        (do ((i k (1+ i))) ((>= i m)) (decf (aref c i k) (* (aref c i l) (aref c k l)))))
      (let ((d (sqrt (max (aref c k k) 1.0d-300))))
        (do ((i k (1+ i))) ((>= i m)) (setf (aref c i k) (/ (aref c i k) d)))))
    (dotimes (k m)
      (setf (svref y k) (/ (svref y k) (aref c k k)))
      (do ((i (1+ k) (1+ i))) ((>= i m)) (decf (svref y i) (* (aref c i k) (svref y k)))))
    (do ((k (1- m) (1- k)))
        ((< k 0))
      (do ((i (1+ k) (1+ i))) ((>= i m)) (decf (svref y k) (* (aref c i k) (svref y i))))
      (setf (svref y k) (/ (svref y k) (aref c k k))))
    (dotimes (i m) (dotimes (k n) (incf (svref dx k) (* (svref y i) (svref (svref rows i) k)))))
    (cons '(mlist) (coerce dx 'list))))

;;; rows of floats, where 0 stands for what is less than eps times the largest of all
(defun $gs__without_rounding (rows eps)
  (let ((largest 0.0d0))
    (dolist (r (cdr rows))
      (dolist (x (cdr r)) (when (> (abs (gs-real x)) largest) (setq largest (abs x)))))
    (gs-list (mapcar #'(lambda (r)
                         (gs-list (mapcar #'(lambda (x) (if (< (abs x) (* eps largest)) 0.0d0 x))
                                          (cdr r))))
                     (cdr rows)))))

;;; The numbers of the rows that do not depend on those before them, by elimination: `pivot` gives
;;; the place of a row's pivot, or false where nothing is left of it; x less s times y is (minus x s
;;; y), y over d (over y d). Zeros are passed over.
(defun gs-independent (rows pivot minus over)
  (let ((basis nil) (kept nil) (number 0))
    (dolist (r rows)
      (incf number)
      (let ((before (copy-seq r)))
        (dolist (b (reverse basis))
          (let ((s (svref r (car b))))
            (unless (zerop s)
              (dolist (e (cdr b))
                (setf (svref r (car e)) (funcall minus (svref r (car e)) s (cdr e))))
              (setf (svref r (car b)) 0))))
        (let ((p (funcall pivot r before)) (entries nil))
          (when p
            (dotimes (i (length r))
              (unless (zerop (svref r i))
                (push (cons i (funcall over (svref r i) (svref r p))) entries)))
            (push (cons p entries) basis)
            (push number kept)))))
    (cons '(mlist) (nreverse kept))))

(defun gs-largest (r)
  (let ((p 0))
    (dotimes (i (length r) p) (when (> (abs (svref r i)) (abs (svref r p))) (setq p i)))))

;;; gs__independent_rows(A, tol), floats: what is left of a row must be above tol times its size;
;;; gs__rows_beyond(A, size): above size.
(defun gs-independent-rows (a least)
  (gs-independent
    (gs-rows a)
    #'(lambda (r before)
        (let ((p (gs-largest r)))
          (and (> (abs (svref r p)) (funcall least before)) p)))
    #'(lambda (x s y) (- x (* s y))) #'/))

(defun $gs__independent_rows (a tol)
  (gs-independent-rows a #'(lambda (r) (* tol (abs (svref r (gs-largest r)))))))

(defun $gs__rows_beyond (a size)
  (gs-independent-rows a #'(lambda (r) (declare (ignore r)) size)))

;;; gs__exact_independent(A), rational numbers: in the field of a prime, where they do not grow.
;;; (A rank found too small would need a minor that the prime 2^31 - 1 divides.)
(defconstant gs-prime 2147483647)

(defun gs-inverse (x)                ; Fermat
  (let ((y 1) (n (- gs-prime 2)))
    (do () ((zerop n) y)
      (when (oddp n) (setq y (mod (* y x) gs-prime)))
      (setq x (mod (* x x) gs-prime) n (ash n -1)))))

(defun gs-residue (x)
  (if (consp x)
      (mod (* (mod (cadr x) gs-prime) (gs-inverse (mod (caddr x) gs-prime))) gs-prime)
      (mod x gs-prime)))

(defun $gs__exact_independent (a)
  (gs-independent
    (mapcar #'(lambda (r) (coerce (mapcar #'gs-residue (cdr r)) 'simple-vector)) (cdr a))
    #'(lambda (r before) (declare (ignore before)) (position-if-not #'zerop r))
    #'(lambda (x s y) (mod (- x (* s y)) gs-prime))
    #'(lambda (y d) (mod (* y (gs-inverse d)) gs-prime))))

;;; ---------------------------------------------------------------------------------------- modes

(defun gs-square (m)
  (let ((n (length (cdr m))))
    (make-array (list n n) :initial-contents
      (mapcar #'(lambda (r) (mapcar #'gs-real (cdr r))) (cdr m)))))

;;; L of A = L L', in place; nil where a pivot is not positive
(defun gs-cholesky (a n)
  (dotimes (j n a)
    (dotimes (k j) (decf (aref a j j) (* (aref a j k) (aref a j k))))
    (if (> (aref a j j) 0) (setf (aref a j j) (sqrt (aref a j j))) (return nil))
    (do ((i (1+ j) (1+ i))) ((>= i n))
      (dotimes (k j) (decf (aref a i j) (* (aref a i k) (aref a j k))))
      (setf (aref a i j) (/ (aref a i j) (aref a j j))))))

;;; the rows of B replaced by those of L^-1 B
(defun gs-solve-rows (l b n)
  (dotimes (c n)
    (dotimes (i n)
      (dotimes (k i) (decf (aref b i c) (* (aref l i k) (aref b k c))))
      (setf (aref b i c) (/ (aref b i c) (aref l i i))))))

(defun gs-transpose (b n)
  (dotimes (i n) (dotimes (j i) (rotatef (aref b i j) (aref b j i)))))

;;; Jacobi's rotations of the symmetric A, until it is diagonal; the rows of V become its vectors
(defun gs-rotate (a v n p q)
  (let* ((th (/ (- (aref a q q) (aref a p p)) (* 2 (aref a p q))))
         (u (/ (if (< th 0) -1.0d0 1.0d0) (+ (abs th) (sqrt (+ 1 (* th th))))))
         (c (/ (sqrt (+ 1 (* u u))))) (s (* u c)))
    (flet ((turn (m i j k l)
             (let ((x (aref m i j)) (y (aref m k l)))
               (setf (aref m i j) (- (* c x) (* s y)) (aref m k l) (+ (* s x) (* c y))))))
      (dotimes (k n) (turn a k p k q))
      (dotimes (k n) (turn a p k q k) (turn v p k q k)))))
(defun gs-diagonalize (a v n)
  (dotimes (sweep 60)
    (let ((off 0.0d0) (all 0.0d0))
      (dotimes (i n)
        (dotimes (j n)
          (incf all (abs (aref a i j)))
          (unless (= i j) (incf off (abs (aref a i j))))))
      (when (<= off (* 1d-15 all)) (return))
      (dotimes (q n)
        (dotimes (p q)
          (when (> (abs (aref a p q)) (* 1d-30 (+ (abs (aref a p p)) (abs (aref a q q)))))
            (gs-rotate a v n p q)))))))

;;; gs__pencil_modes(K, M): [[x, v], ...] of K v = x M v, v'M v = 1, x rising; K and M symmetric;
;;; false if M is not positive definite.
(defun $gs__pencil_modes (k m)
  (let* ((n (length (cdr k))) (a (gs-square k)) (l (gs-cholesky (gs-square m) n))
         (v (make-array (list n n) :initial-element 0.0d0)) (found nil))
    (when l
      (gs-solve-rows l a n)
      (gs-transpose a n)
      (gs-solve-rows l a n)
      (dotimes (i n) (setf (aref v i i) 1.0d0))
      (gs-diagonalize a v n)
      (dotimes (i n (gs-list (stable-sort found #'< :key #'cadr)))
        (do ((r (1- n) (1- r))) ((< r 0))   ; L' y = v
          (do ((c (1+ r) (1+ c))) ((>= c n)) (decf (aref v i r) (* (aref l c r) (aref v i c))))
          (setf (aref v i r) (/ (aref v i r) (aref l r r))))
        (push (gs-list (list (aref a i i)
                (gs-list (loop for c below n collect (aref v i c))))) found)))))
