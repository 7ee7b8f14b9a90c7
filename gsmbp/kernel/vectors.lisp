;;; kernel/vectors.lisp: vectors and matrices (Maxima lists) in Lisp: every number of a derivation
;;; passes through here. Plain algebra: no expansion, no simplification beyond Maxima's own.
(in-package :maxima)
;;; the product of two different symbols is put together here: Maxima's simplifier takes several
;;; times as long for it
(defun gs-times (a b)
  (cond ((eql a 0) 0)
        ((eql b 0) 0)
        ((eql a 1) b)
        ((eql b 1) a)
        ((and a b (symbolp a) (symbolp b) (not (eq a b)))
         (if (great a b) (list '(mtimes simp) b a) (list '(mtimes simp) a b)))
        (t (mul2 a b))))
(defun gs-minus (a) (if (numberp a) (- a) (mul2 -1 a)))
(defun gs-plus (terms)                ; the sum of a Lisp list, made in one call
  (let ((l (remove 0 terms)))
    (cond ((null l) 0) ((null (cdr l)) (car l)) (t (addn l t)))))

(defun gs-sum (a b) (gs-plus (list a b)))
(defun gs-difference (a b) (if (eql b 0) a (gs-plus (list a (gs-minus b)))))
(defun gs-inner (a b) (gs-plus (mapcar #'gs-times a b)))

;;; vectors, or matrices, element by element
(defun gs-matrix-p (a) ($listp (cadr a)))
(defun gs-by-elements (f a) (gs-list (apply #'mapcar f (mapcar #'cdr a))))
(defun $gs__add (&rest a)
  (gs-by-elements (if (gs-matrix-p (car a)) #'$gs__add #'(lambda (&rest x) (gs-plus x))) a))
(defun $gs__subtract (a b)
  (gs-by-elements (if (gs-matrix-p a) #'$gs__subtract #'gs-difference) (list a b)))
(defun $gs__scale (k a)
  (let ((f (if (gs-matrix-p a) #'$gs__scale #'gs-times)))
    (gs-by-elements #'(lambda (x) (funcall f k x)) (list a))))
(defun $gs__dot (a b) (gs-inner (cdr a) (cdr b)))
(defun $gs__cross (a b)
  (destructuring-bind (a1 a2 a3) (cdr a)
    (destructuring-bind (b1 b2 b3) (cdr b)
      (flet ((minor (x y z w) (gs-difference (gs-times x y) (gs-times z w))))
        (gs-list (list (minor a2 b3 a3 b2) (minor a3 b1 a1 b3) (minor a1 b2 a2 b1)))))))

(defun $gs__transpose (a)
  (do ((rows (mapcar #'cdr (cdr a)) (mapcar #'cdr rows)) (columns nil))
      ((null (car rows)) (gs-list (nreverse columns)))
    (push (gs-list (mapcar #'car rows)) columns)))
;;; a matrix times a vector or a matrix
(defun $gs__times (a b)
  (if (gs-matrix-p b)
      (let ((columns ($gs__transpose b)))
        (gs-by-elements #'(lambda (r) ($gs__times columns r)) (list a)))
      (gs-by-elements #'(lambda (r) (gs-inner (cdr r) (cdr b))) (list a))))

;;; the matrix of the cross product: skew(a).b = a x b; the dyad a b'
(defun $gs__skew (a)
  (destructuring-bind (x y z) (cdr a)
    (gs-list
      (list (gs-list (list 0 (gs-minus z) y))
            (gs-list (list z 0 (gs-minus x)))
            (gs-list (list (gs-minus y) x 0))))))
(defun $gs__outer (a b) (gs-list (mapcar #'(lambda (x) ($gs__scale x b)) (cdr a))))

(defun $gs__trace (a) ; in three dimensions
  (destructuring-bind (x y z) (cdr a)
    (gs-plus (list (cadr x) (caddr y) (cadddr z)))))
;;; the axial vector of a matrix: vec(A), A r - A' r = vec(A) x r
(defun $gs__axial (a)
  (destructuring-bind ((xx xy xz) (yx yy yz) (zx zy zz)) (mapcar #'cdr (cdr a))
    (declare (ignore xx yy zz))
    (gs-list (list (gs-difference zy yz) (gs-difference xz zx) (gs-difference yx xy)))))
;;; (v.r) 1 - v r'
(defun $gs__spread_tensor (v r)
  ($gs__add ($gs__scale ($gs__dot v r) ($gs__identity)) ($gs__scale -1 ($gs__outer v r))))

;;; a matrix with its entries expanded
(defun $gs__expanded_matrix (a)
  (gs-by-elements #'(lambda (row) (gs-list (mapcar #'$expand (cdr row)))) (list a)))
;;; true of x, y, z and their opposites; of a vector that vanishes
(defun $gs__along_axisp (e)
  (let ((l (remove 0 (cdr e)))) (and l (null (cdr l)) (eql (gs-times (car l) (car l)) 1))))
(defun $gs__zero_vectorp (v) (every #'(lambda (x) (eql ($ratsimp x) 0)) (cdr v)))
