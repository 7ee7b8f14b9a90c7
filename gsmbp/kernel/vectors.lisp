;;; kernel/vectors.lisp: vectors and matrices (Maxima lists) in Lisp: every number of a derivation
;;; passes through here. Plain algebra: no expansion, no simplification beyond Maxima's own.
(in-package :maxima)
;;; the product of two different symbols is put together here: Maxima's simplifier takes several
;;; times as long for it
(defun gsmbp-times (a b)
  (cond ((eql a 0) 0)
        ((eql b 0) 0)
        ((eql a 1) b)
        ((eql b 1) a)
        ((and a b (symbolp a) (symbolp b) (not (eq a b)))
         (if (great a b) (list '(mtimes simp) b a) (list '(mtimes simp) a b)))
        (t (mul2 a b))))
(defun gsmbp-minus (a) (if (numberp a) (- a) (mul2 -1 a)))
(defun gsmbp-plus (terms)                ; the sum of a Lisp list, made in one call
  (let ((l (remove 0 terms)))
    (cond ((null l) 0) ((null (cdr l)) (car l)) (t (addn l t)))))

(defun gsmbp-sum (a b) (gsmbp-plus (list a b)))
(defun gsmbp-difference (a b) (if (eql b 0) a (gsmbp-plus (list a (gsmbp-minus b)))))
(defun gsmbp-inner (a b) (gsmbp-plus (mapcar #'gsmbp-times a b)))

;;; vectors added, element by element
(defun $gsmbp__vadd (&rest v)
  (do ((l (mapcar #'cdr v) (mapcar #'cdr l)) (sum nil)) ((null (car l)) (gsmbp-list (nreverse sum)))
    (push (gsmbp-plus (mapcar #'car l)) sum)))
(defun $gsmbp__vsub (a b) (gsmbp-list (mapcar #'gsmbp-difference (cdr a) (cdr b))))
(defun $gsmbp__vscale (k a) (gsmbp-list (mapcar #'(lambda (x) (gsmbp-times k x)) (cdr a))))
(defun $gsmbp__dot (a b) (gsmbp-inner (cdr a) (cdr b)))
(defun $gsmbp__cross (a b)
  (destructuring-bind (a1 a2 a3) (cdr a)
    (destructuring-bind (b1 b2 b3) (cdr b)
      (flet ((minor (x y z w) (gsmbp-difference (gsmbp-times x y) (gsmbp-times z w))))
        (gsmbp-list (list (minor a2 b3 a3 b2) (minor a3 b1 a1 b3) (minor a1 b2 a2 b1)))))))

(defun $gsmbp__matvec (a v)
  (gsmbp-list (mapcar #'(lambda (r) (gsmbp-inner (cdr r) (cdr v))) (cdr a))))
(defun $gsmbp__transpose (a)
  (do ((rows (mapcar #'cdr (cdr a)) (mapcar #'cdr rows)) (columns nil))
      ((null (car rows)) (gsmbp-list (nreverse columns)))
    (push (gsmbp-list (mapcar #'car rows)) columns)))
(defun $gsmbp__matmul (a b)
  (let ((columns ($gsmbp__transpose b)))
    (gsmbp-list (mapcar #'(lambda (r) ($gsmbp__matvec columns r)) (cdr a)))))
(defun $gsmbp__madd (&rest m)
  (do ((l (mapcar #'cdr m) (mapcar #'cdr l)) (rows nil))
      ((null (car l)) (gsmbp-list (nreverse rows)))
    (push (apply #'$gsmbp__vadd (mapcar #'car l)) rows)))
(defun $gsmbp__mscale (k a) (gsmbp-list (mapcar #'(lambda (r) ($gsmbp__vscale k r)) (cdr a))))

;;; the matrix of the cross product: skew(a).b = a x b; the dyad a b'
(defun $gsmbp__skew (a)
  (destructuring-bind (x y z) (cdr a)
    (gsmbp-list
      (list (gsmbp-list (list 0 (gsmbp-minus z) y))
            (gsmbp-list (list z 0 (gsmbp-minus x)))
            (gsmbp-list (list (gsmbp-minus y) x 0))))))
(defun $gsmbp__outer (a b) (gsmbp-list (mapcar #'(lambda (x) ($gsmbp__vscale x b)) (cdr a))))
