;;; kernel/span.lisp: can an expression have a real, finite value at all?
;;;
;;; Interval arithmetic: a span (lo . hi) holds every real value that an expression can have;
;;; symbols have the span of their value, or any. Where nothing is left (the root or logarithm of
;;; what is negative, a division by zero, %i, inf) the value is not real and finite. Values above
;;; gs-span-huge count as endless. What is wrong by rounding alone is not refused.
(in-package :maxima)

(defvar gs-span-huge 1d150)
(defvar gs-span-any (cons -1d150 1d150))
(defvar gs-span-slack 1d-9)

;;; The part of e that is not real and finite where the symbols of the hash `known` have the values
;;; in it; true if there is none.
(defun $gs__unreal_part (e known) (catch 'unreal (gs-span e known) t))

(defun gs-span-clamp (x)
  (cond ((> x gs-span-huge) gs-span-huge)
        ((< x (- gs-span-huge)) (- gs-span-huge))
        (t (coerce x 'double-float))))
(defun gs-span-between (&rest l)
  (let ((l (mapcar #'gs-span-clamp l))) (cons (apply #'min l) (apply #'max l))))
(defun gs-span-point-p (s) (and (= (car s) (cdr s)) (< (abs (car s)) gs-span-huge)))
(defun gs-span-zero-p (s) (and (= (car s) 0) (= (cdr s) 0)))

(defun gs-span (e known)
  (cond ((realp e) (gs-span-number e e))
        ((symbolp e) (gs-span-symbol e known))
        ((atom e) gs-span-any)
        ((eq (caar e) 'rat) (gs-span-number (/ (cadr e) (caddr e)) e))
        ((eq (caar e) 'bigfloat) (gs-span ($gs__exact e) known))
        ((member (caar e) '(lambda mquote)) gs-span-any)
        (t (let ((s (mapcar #'(lambda (x) (gs-span x known)) (cdr e))))
             (or (gs-span-of (caar e) s (cdr e)) (throw 'unreal e))))))

;;; numbers that a double cannot hold well are refused
(defun gs-span-number (x e)
  (let ((r (cond ((not (floatp x)) (abs x))
                 ((and (= x x) (<= (abs x) most-positive-double-float)) (abs (rational x)))
                 (t (throw 'unreal e)))))
    (when (and (/= r 0) (or (> r (expt 10 300)) (< r (expt 10 -300)))) (throw 'unreal e))
    (if (< r (expt 10 -150)) (cons 0d0 0d0) (gs-span-between x))))

(defun gs-span-symbol (e known)
  (cond ((member e '($inf $minf $infinity $und $ind $%i)) (throw 'unreal e))
        ((eq e '$%pi) (gs-span-between pi))
        ((eq e '$%e) (gs-span-between (cl:exp 1d0)))
        (t (let ((v (gethash e known))) (if v (gs-span v known) gs-span-any)))))

;;; Span of an operator's value from those of its arguments; nil if it has none.
(defun gs-span-of (o s args)
  (case o
    (mplus (gs-span-between (reduce #'+ (mapcar #'car s)) (reduce #'+ (mapcar #'cdr s))))
    (mtimes (reduce #'gs-span-times s))
    (mexpt (gs-span-power (first s) (second s) (second args)))
    (t (if (= (length s) 1) (gs-span-function o (car s))
         (and (not (and (eq o '%atan2) (every #'gs-span-zero-p s))) gs-span-any)))))

(defun gs-span-function (o a)
  (case o
    (%log (and (> (cdr a) 0)
            (gs-span-between (gs-span-log (car a)) (gs-span-log (cdr a)))))
    (%sin (gs-span-at #'cl:sin a (cons -1d0 1d0)))
    (%cos (gs-span-at #'cl:cos a (cons -1d0 1d0)))
    (%tan (gs-span-at #'cl:tan a gs-span-any))
    ((%asin %acos) (and (<= (car a) (+ 1 gs-span-slack)) (>= (cdr a) (- -1 gs-span-slack))
                     (cons -1.6d0 3.2d0)))
    (%atan (cons -1.6d0 1.6d0))
    ((%tanh %signum) (cons -1d0 1d0))
    ((mabs %abs) (let ((l (list (abs (car a)) (abs (cdr a)))))
                   (apply #'gs-span-between (if (<= (car a) 0 (cdr a)) (cons 0 l) l))))
    (t gs-span-any)))

(defun gs-span-log (x) (if (> x 1d-150) (cl:log x) (- gs-span-huge)))
;;; of a function of which only the value at a point is of interest
(defun gs-span-at (f s wide)
  (if (and (gs-span-point-p s) (< (abs (car s)) 1d9))
    (gs-span-between (funcall f (car s)))
    wide))
;;; endless times zero: the end is not reached, so zero
(defun gs-span-times (a b)
  (gs-span-between (* (car a) (car b)) (* (car a) (cdr b))
    (* (cdr a) (car b)) (* (cdr a) (cdr b))))

;;; a^b, b being the exponent e as it is written: a whole number, another number, or anything
(defun gs-span-power (a b e)
  (cond ((integerp e) (gs-span-whole a e))
        ((and (gs-span-point-p b) (= (car b) (ffloor (car b))) (< (abs (car b)) 1d6))
         (gs-span-whole a (round (car b))))
        ((< (cdr a) (* -1 gs-span-slack (min 1d3 (max 1d0 (abs (car a)))))) nil)
        ((and (gs-span-zero-p a) (< (cdr b) 0)) nil)
        ((and (gs-span-point-p a) (gs-span-point-p b) (> (car a) 0))
         (gs-span-exp (* (car b) (cl:log (car a)))))
        ((and (>= (car a) 1) (>= (car b) 0)) (cons 1d0 gs-span-huge))
        (t (cons 0d0 gs-span-huge))))
(defun gs-span-exp (x)
  (gs-span-between (if (> (abs x) 345) (if (> x 0) gs-span-huge 0) (cl:exp x))))

(defun gs-span-whole (a n)
  (cond ((= n 0) (cons 1d0 1d0))
        ((< n 0) (gs-span-inverse (gs-span-whole a (- n))))
        (t (let ((lo (gs-span-raised (car a) n)) (hi (gs-span-raised (cdr a) n)))
             (if (and (evenp n) (<= (car a) 0 (cdr a)))
               (gs-span-between 0 lo hi)
               (gs-span-between lo hi))))))
(defun gs-span-raised (x n)
  (if (= x 0) 0d0
    (* (if (and (oddp n) (< x 0)) -1 1) (car (gs-span-exp (* n (cl:log (abs x))))))))
(defun gs-span-inverse (s)
  (cond ((gs-span-zero-p s) nil)
        ((<= (car s) 0 (cdr s)) gs-span-any)
        (t (gs-span-between (/ 1 (car s)) (/ 1 (cdr s))))))

;;; whether an expression of finite numbers is finite whatever they are
(defun $gs__always_finite (e)
  (or ($mapatom e)
      (case (caar e)
        (mexpt (and (integerp (caddr e)) (plusp (caddr e)) ($gs__always_finite (cadr e))))
        ((mlist mplus mtimes %sin %cos) (every #'$gs__always_finite (cdr e))))))
