;;; emit/numbers.lisp: numbers as decimals.
(in-package :maxima)

;;; true if 1e-300 < r < 1e300
(defvar *gs-largest* (expt 10 300))

(defun $gs__representable (r)
  (let ((q (gs-rational r)))
    (and (< (numerator q) (* *gs-largest* (denominator q)))
         (< (denominator q) (* *gs-largest* (numerator q))))))

;;; n/10^k (n > 0, not divisible by 10) as text: plain, or with an exponent behind `mark` when it is
;;; small or large
(defun $gs__decimal_text (n k mark)
  (let* ((s (format nil "~d" n)) (p (- (length s) k)))          ; the number is 0.s * 10^p
    (flet ((zeros (n) (make-string (max 0 n) :initial-element #\0)))
      (cond ((or (< p -1) (> p 7)) (gs-text (gs-pointed s 1) mark (format nil "~d" (1- p))))
            ((<= p 0) (gs-text "0." (zeros (- p)) s))
            (t (gs-pointed (gs-text s (zeros (- p (length s)))) p))))))

;;; the digits s with a point behind the p-th and at least one digit behind the point
(defun gs-pointed (s p) (gs-text (subseq s 0 p) "." (if (> (length s) p) (subseq s p) "0")))
