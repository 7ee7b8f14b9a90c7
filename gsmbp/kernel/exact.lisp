;;; kernel/exact.lisp: exact numbers: decimals as typed, logarithms, the digits of a fraction.
(in-package :maxima)

;;; The expression e with every float and bigfloat in it replaced by its exact decimal; lists,
;;; matrices and equations are entered as well. Nothing is evaluated.
(defun $gs__exact (e)
  (cond ((floatp e)
         (let ((q (gs-decimal e)))
           (if (integerp q) q (list '(rat simp) (numerator q) (denominator q)))))
        ((or (atom e) (not (gs-inexact-p e))) e)
        ((eq (caar e) 'bigfloat) (mfuncall '$gs__decimal e))
        ((eq (caar e) 'mrat) ($gs__exact ($ratdisrep e)))
        (($mapatom e) e)
        (t (simplifya (cons (list (caar e)) (mapcar #'$gs__exact (cdr e))) nil))))

(defun gs-rational (r) (if (integerp r) r (/ (cadr r) (caddr r))))

;;; [n, k] with r = n/10^k and n not divisible by 10 if the rational r > 0 has a finite decimal
;;; fraction; else false
(defun $gs__finite_decimal (r)
  (let* ((q (gs-rational r)) (d (denominator q)) (k 0))
    (flet ((times-of (p) (do ((n 0 (1+ n))) ((plusp (mod d p)) n) (setq d (/ d p)))))
      (setq k (max (times-of 2) (times-of 5)))
      (when (= d 1)
        (let ((n (* q (expt 10 k))))
          (do () ((plusp (mod n 10))) (setq n (/ n 10) k (1- k)))
          (gs-list (list n k)))))))

;;; Is a rational better read as a fraction (3/8) than as a decimal (981/100, 1009/3000)?
(defun $gs__fractionp (r)
  (let ((q (gs-rational r)))
    (not (or (integerp q) ($gs__short_decimalp r)
             (>= (abs (numerator q)) 1000) (>= (denominator q) 1000)))))
;;; 9.81: a power of five below, at most twelve digits
(defun $gs__short_decimalp (r)
  (let ((d (denominator (gs-rational r))) (k 0))
    (loop while (zerop (mod d 5)) do (setq d (/ d 5) k (1+ k)))
    (and (< 0 k 13) (<= d 4096) (zerop (logand d (1- d))))))

;;; [e with a symbol for every rational that is read as a decimal, [symbol = its magnitude, ...]].
;;; The sign stays with the product or the number that has it. No name is the beginning of another.
(defvar gs-decimals-found nil)
(defun $gs__decimals_marked (e)
  (let* ((gs-decimals-found nil) (marked (gs-mark-decimals e)))
    (gs-list (list marked
                   (gs-list (mapcar (lambda (p) (list '(mequal simp) (car p) (cdr p)))
                                    gs-decimals-found))))))
(defun gs-mark-decimals (e)
  (cond ((atom e) e)
        ((eq (caar e) 'rat) (gs-decimal-symbol e nil))
        ((eq (caar e) 'mexpt) (list (car e) (gs-mark-decimals (cadr e)) (caddr e)))
        ((and (eq (caar e) 'mtimes) (consp (cadr e)) (eq (caaadr e) 'rat))
         (let ((n (gs-decimal-symbol (cadr e) t)))
           (append (list (car e)) n (mapcar #'gs-mark-decimals (cddr e)))))
        (t (cons (car e) (mapcar #'gs-mark-decimals (cdr e))))))
;;; a symbol for r or -1 times one, r itself where it is read as a fraction; as factors of a product
(defun gs-decimal-symbol (r factor)
  (let ((negative (minusp (cadr r))) (symbol nil))
    (if ($gs__fractionp r) (if factor (list r) r)
      (progn
        (setq symbol (intern (format nil "$GS__NUMBER~dX" (length gs-decimals-found)) :maxima))
        (push (cons symbol (list '(rat simp) (abs (cadr r)) (caddr r))) gs-decimals-found)
        (cond (factor (if negative (list -1 symbol) (list symbol)))
              (negative (list '(mtimes simp) -1 symbol))
              (t symbol))))))

;;; true if no principal minor of a symmetric 3x3 matrix of exact numbers is negative
(defun $gs__exact_semidefinite (matrix)
  (destructuring-bind ((a h g) (h2 b f) (g2 f2 c))
      (mapcar #'(lambda (row) (mapcar #'gs-rational (cdr row))) (cdr matrix))
    (declare (ignore h2 g2 f2))
    (let ((bc (- (* b c) (* f f))))
      (notany #'minusp
              (list a b c bc (- (* a c) (* g g)) (- (* a b) (* h h))
                    (+ (* a bc) (- (* h (- (* h c) (* f g)))) (* g (- (* h f) (* b g)))))))))
