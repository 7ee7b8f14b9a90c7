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
