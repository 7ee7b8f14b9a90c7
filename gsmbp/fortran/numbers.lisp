;;; fortran/numbers.lisp: numbers as DOUBLE PRECISION constants.
(in-package :maxima)

;;; true if 1e-300 < r < 1e300
(defvar *gsmbp-largest* (expt 10 300))

(defun $gsmbp__representable (r)
  (let ((q (gsmbp-rational r)))
    (and (< (numerator q) (* *gsmbp-largest* (denominator q)))
         (< (denominator q) (* *gsmbp-largest* (numerator q))))))

;;; n/10^k (n > 0, not divisible by 10) as text: plain, or with an exponent behind `mark` when it is
;;; small or large
(defun $gsmbp__decimal_text (n k mark)
  (let* ((s (format nil "~d" n)) (p (- (length s) k)))          ; the number is 0.s * 10^p
    (flet ((zeros (n) (make-string (max 0 n) :initial-element #\0)))
      (cond ((or (< p -1) (> p 7)) (gsmbp-text (gsmbp-pointed s 1) mark (format nil "~d" (1- p))))
            ((<= p 0) (gsmbp-text "0." (zeros (- p)) s))
            (t (gsmbp-pointed (gsmbp-text s (zeros (- p (length s)))) p))))))

;;; the digits s with a point behind the p-th and at least one digit behind the point
(defun gsmbp-pointed (s p) (gsmbp-text (subseq s 0 p) "." (if (> (length s) p) (subseq s p) "0")))

;;; [n, k] as a DOUBLE PRECISION constant
(defun $gsmbp__constant (d)
  (let ((text ($gsmbp__decimal_text (cadr d) (caddr d) "D")))
    (if (find #\D text) text (gsmbp-text text "D0"))))
