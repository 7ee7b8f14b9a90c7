;;; kernel/span.lisp: can an expression have a real, finite value at all?
;;;
;;; Interval arithmetic: a span (lo . hi) holds every real value that an expression can have;
;;; symbols have the span of their value, or any. Where nothing is left (the root or logarithm of
;;; what is negative, a division by zero, %i, inf) the value is not real and finite. Values above
;;; gsmbp-span-huge count as endless. What is wrong by rounding alone is not refused.
(in-package :maxima)

(defvar gsmbp-span-huge 1d150)
(defvar gsmbp-span-any (cons -1d150 1d150))
(defvar gsmbp-span-slack 1d-9)

;;; The part of e that is not real and finite where the symbols of the hash `known` have the values
;;; in it; true if there is none.
(defun $gsmbp__unreal_part (e known) (catch 'unreal (gsmbp-span e known) t))

(defun gsmbp-span-clamp (x)
  (cond ((> x gsmbp-span-huge) gsmbp-span-huge)
        ((< x (- gsmbp-span-huge)) (- gsmbp-span-huge))
        (t (coerce x 'double-float))))
(defun gsmbp-span-between (&rest l)
  (let ((l (mapcar #'gsmbp-span-clamp l))) (cons (apply #'min l) (apply #'max l))))
(defun gsmbp-span-point-p (s) (and (= (car s) (cdr s)) (< (abs (car s)) gsmbp-span-huge)))
(defun gsmbp-span-zero-p (s) (and (= (car s) 0) (= (cdr s) 0)))

(defun gsmbp-span (e known)
  (cond ((realp e) (gsmbp-span-number e e))
        ((symbolp e) (gsmbp-span-symbol e known))
        ((atom e) gsmbp-span-any)
        ((eq (caar e) 'rat) (gsmbp-span-number (/ (cadr e) (caddr e)) e))
        ((eq (caar e) 'bigfloat) (gsmbp-span ($gsmbp__exact e) known))
        ((member (caar e) '(lambda mquote)) gsmbp-span-any)
        (t (let ((s (mapcar #'(lambda (x) (gsmbp-span x known)) (cdr e))))
             (or (gsmbp-span-of (caar e) s (cdr e)) (throw 'unreal e))))))

;;; numbers that a double cannot hold well are refused
(defun gsmbp-span-number (x e)
  (let ((r (cond ((not (floatp x)) (abs x))
                 ((and (= x x) (<= (abs x) most-positive-double-float)) (abs (rational x)))
                 (t (throw 'unreal e)))))
    (when (and (/= r 0) (or (> r (expt 10 300)) (< r (expt 10 -300)))) (throw 'unreal e))
    (if (< r (expt 10 -150)) (cons 0d0 0d0) (gsmbp-span-between x))))

(defun gsmbp-span-symbol (e known)
  (cond ((member e '($inf $minf $infinity $und $ind $%i)) (throw 'unreal e))
        ((eq e '$%pi) (gsmbp-span-between pi))
        ((eq e '$%e) (gsmbp-span-between (cl:exp 1d0)))
        (t (let ((v (gethash e known))) (if v (gsmbp-span v known) gsmbp-span-any)))))

;;; Span of an operator's value from those of its arguments; nil if it has none.
(defun gsmbp-span-of (o s args)
  (case o
    (mplus (gsmbp-span-between (reduce #'+ (mapcar #'car s)) (reduce #'+ (mapcar #'cdr s))))
    (mtimes (reduce #'gsmbp-span-times s))
    (mexpt (gsmbp-span-power (first s) (second s) (second args)))
    (t (if (= (length s) 1) (gsmbp-span-function o (car s))
         (and (not (and (eq o '%atan2) (every #'gsmbp-span-zero-p s))) gsmbp-span-any)))))

(defun gsmbp-span-function (o a)
  (case o
    (%log (and (> (cdr a) 0)
            (gsmbp-span-between (gsmbp-span-log (car a)) (gsmbp-span-log (cdr a)))))
    (%sin (gsmbp-span-at #'cl:sin a (cons -1d0 1d0)))
    (%cos (gsmbp-span-at #'cl:cos a (cons -1d0 1d0)))
    (%tan (gsmbp-span-at #'cl:tan a gsmbp-span-any))
    ((%asin %acos) (and (<= (car a) (+ 1 gsmbp-span-slack)) (>= (cdr a) (- -1 gsmbp-span-slack))
                     (cons -1.6d0 3.2d0)))
    (%atan (cons -1.6d0 1.6d0))
    (%tanh (cons -1d0 1d0))
    ((mabs %abs) (let ((l (list (abs (car a)) (abs (cdr a)))))
                   (apply #'gsmbp-span-between (if (<= (car a) 0 (cdr a)) (cons 0 l) l))))
    (t gsmbp-span-any)))

(defun gsmbp-span-log (x) (if (> x 1d-150) (cl:log x) (- gsmbp-span-huge)))
;;; of a function of which only the value at a point is of interest
(defun gsmbp-span-at (f s wide)
  (if (and (gsmbp-span-point-p s) (< (abs (car s)) 1d9))
    (gsmbp-span-between (funcall f (car s)))
    wide))
;;; endless times zero: the end is not reached, so zero
(defun gsmbp-span-times (a b)
  (gsmbp-span-between (* (car a) (car b)) (* (car a) (cdr b))
    (* (cdr a) (car b)) (* (cdr a) (cdr b))))

;;; a^b, b being the exponent e as it is written: a whole number, another number, or anything
(defun gsmbp-span-power (a b e)
  (cond ((integerp e) (gsmbp-span-whole a e))
        ((and (gsmbp-span-point-p b) (= (car b) (ffloor (car b))) (< (abs (car b)) 1d6))
         (gsmbp-span-whole a (round (car b))))
        ((< (cdr a) (* -1 gsmbp-span-slack (min 1d3 (max 1d0 (abs (car a)))))) nil)
        ((and (gsmbp-span-zero-p a) (< (cdr b) 0)) nil)
        ((and (gsmbp-span-point-p a) (gsmbp-span-point-p b) (> (car a) 0))
         (gsmbp-span-exp (* (car b) (cl:log (car a)))))
        ((and (>= (car a) 1) (>= (car b) 0)) (cons 1d0 gsmbp-span-huge))
        (t (cons 0d0 gsmbp-span-huge))))
(defun gsmbp-span-exp (x)
  (gsmbp-span-between (if (> (abs x) 345) (if (> x 0) gsmbp-span-huge 0) (cl:exp x))))

(defun gsmbp-span-whole (a n)
  (cond ((= n 0) (cons 1d0 1d0))
        ((< n 0) (gsmbp-span-inverse (gsmbp-span-whole a (- n))))
        (t (let ((lo (gsmbp-span-raised (car a) n)) (hi (gsmbp-span-raised (cdr a) n)))
             (if (and (evenp n) (<= (car a) 0 (cdr a)))
               (gsmbp-span-between 0 lo hi)
               (gsmbp-span-between lo hi))))))
(defun gsmbp-span-raised (x n)
  (if (= x 0) 0d0
    (* (if (and (oddp n) (< x 0)) -1 1) (car (gsmbp-span-exp (* n (cl:log (abs x))))))))
(defun gsmbp-span-inverse (s)
  (cond ((gsmbp-span-zero-p s) nil)
        ((<= (car s) 0 (cdr s)) gsmbp-span-any)
        (t (gsmbp-span-between (/ 1 (car s)) (/ 1 (cdr s))))))
