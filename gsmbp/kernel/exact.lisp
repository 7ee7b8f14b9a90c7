;;; kernel/exact.lisp: exact numbers: decimals as typed, logarithms, the digits of a fraction.
(in-package :maxima)

;;; The expression e with every float and bigfloat in it replaced by its exact decimal; lists,
;;; matrices and equations are entered as well. Nothing is evaluated.
(defun $gsmbp__exact (e)
  (cond ((floatp e)
         (let ((q (gsmbp-decimal e)))
           (if (integerp q) q (list '(rat simp) (numerator q) (denominator q)))))
        ((or (atom e) (not (gsmbp-inexact-p e))) e)
        ((eq (caar e) 'bigfloat) (mfuncall '$gsmbp__decimal e))
        ((eq (caar e) 'mrat) ($gsmbp__exact ($ratdisrep e)))
        (($mapatom e) e)
        (t (simplifya (cons (list (caar e)) (mapcar #'$gsmbp__exact (cdr e))) nil))))

(defun gsmbp-rational (r) (if (integerp r) r (/ (cadr r) (caddr r))))

;;; [n, k] with r = n/10^k and n not divisible by 10 if the rational r > 0 has a finite decimal
;;; fraction; else false
(defun $gsmbp__finite_decimal (r)
  (let* ((q (gsmbp-rational r)) (d (denominator q)) (k 0))
    (flet ((times-of (p) (do ((n 0 (1+ n))) ((plusp (mod d p)) n) (setq d (/ d p)))))
      (setq k (max (times-of 2) (times-of 5)))
      (when (= d 1)
        (let ((n (* q (expt 10 k))))
          (do () ((plusp (mod n 10))) (setq n (/ n 10) k (1- k)))
          (gsmbp-list (list n k)))))))
