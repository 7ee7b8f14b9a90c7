;;; tape/operations.lisp: the operations of an expression, counted on its tree as it will be
;;; printed: a quotient of numbers is a division, x^3 two multiplications.
(in-package :maxima)

(defvar *gs-muls* 0)
(defvar *gs-adds* 0)
(defvar *gs-divs* 0)
(defvar *gs-sqrts* 0)
(defvar *gs-calls* 0)

;;; [mul, add, div, sqrt, trig] of one expression
(defun $gs__expression_count (e)
  (let ((*gs-muls* 0) (*gs-adds* 0) (*gs-divs* 0) (*gs-sqrts* 0) (*gs-calls* 0))
    (gs-count-sum e)
    (gs-list (list *gs-muls* *gs-adds* *gs-divs* *gs-sqrts* *gs-calls*))))

;;; the same of entries [target, value, ...] of code, each once; of a pair [sine, cosine] what was
;;; asked for; none of a statement or a place
(defun $gs__entries_count (entries)
  (let ((*gs-muls* 0) (*gs-adds* 0) (*gs-divs* 0) (*gs-sqrts* 0) (*gs-calls* 0))
    (dolist (c (cdr entries))
      (destructuring-bind (target value &rest others) (cdr c)
        (when ($listp target)
          (incf *gs-calls* (count '$idle (cdr target) :test-not #'eq)))
        (unless (or (null target) (stringp value) (gs-place-p value)) (gs-count-sum value))))
    (gs-list (list *gs-muls* *gs-adds* *gs-divs* *gs-sqrts* *gs-calls*))))
;;; is it a place, gs__el("A", i, j)?
(defun gs-place-p (e) (and (consp e) (eq (caar e) '$gs__el_)))
;;; the sum of such counts
(defun $gs__total (counts)
  (gs-list (reduce #'(lambda (a b) (mapcar #'+ a b)) (mapcar #'cdr (cdr counts))
                   :initial-value (list 0 0 0 0 0))))
;;; multiplications, additions and divisions
(defun $gs__operations (e) (apply #'+ (subseq (cdr ($gs__expression_count e)) 0 3)))

(defun gs-negative-p (number) ($gs__starts_negative number))
(defun gs-magnitude (number) (if (gs-negative-p number) (gs-minus number) number))
(defun gs-exact (number)
  (if (or (integerp number) (ratnump number)) number (mfuncall '$gs__exact number)))

(defun gs-count-sum (e)
  (cond ((symbolp e))
        ((gs-sum-p e)
         (incf *gs-adds* (1- (length (cdr e))))
         (mapc #'gs-count-term (cdr e)))
        (t (gs-count-term e))))

(defun gs-count-term (e)
  (cond ((symbolp e))
        ((mnump e) (gs-count-number e))
        ((gs-product-p e)
         (if (mnump (cadr e))
             (gs-count-product (gs-magnitude (cadr e)) (cddr e))
             (gs-count-product 1 (cdr e))))
        ((gs-power-p e) (gs-count-product 1 (list e)))
        (t (gs-count-factor e))))

;;; a number is one constant, or the quotient of two
(defun gs-count-number (r)
  (when (gs-quotient-p (gs-magnitude r)) (incf *gs-divs*)))

;;; c > 0 times factors; powers with a negative exponent are divisors
(defun gs-count-product (c factors)
  (let ((c (gs-exact c)) (above 0) (below 0))
    (dolist (f factors)
      (cond ((symbolp f) (incf above))
            ((not (gs-power-p f)) (gs-count-factor f) (incf above))
            ((gs-divisor-p f)
             (incf below (gs-count-power (cadr f) (gs-minus (caddr f)))))
            (t (incf above (gs-count-power (cadr f) (caddr f))))))
    (cond ((eql c 1))
          ((not (gs-quotient-p c)) (incf above))
          ((eql (cadr c) 1) (incf below))
          ((plusp below) (incf above) (incf below))
          (t (incf *gs-divs*) (incf above)))
    (incf *gs-muls* (max 0 (1- above)))
    (when (plusp below)
      (incf *gs-divs*)
      (incf *gs-muls* (1- below)))))

;;; the number of factors of b^n; n > 0 if it is a number
(defun gs-count-power (b n)
  (if (eq b '$%e)
      (progn (incf *gs-calls*) (gs-count-sum n) 1)
      (let ((q (if (mnump n) (gs-times 4 (gs-exact n)))))
        (cond ((not (integerp q))
               (incf *gs-calls*)
               (gs-count-base b)
               (gs-count-factor n)
               1)
              ((evenp q) (gs-count-root b (/ q 2)))
              (t (incf *gs-sqrts* 2)
                 (gs-count-sum b)
                 (1+ (gs-count-root b (/ (1- q) 2))))))))

;;; ... of b^(h/2)
(defun gs-count-root (b h)
  (if (evenp h)
      (gs-count-integer-power b (/ h 2))
      (progn (incf *gs-sqrts*)
             (gs-count-sum b)
             (1+ (gs-count-integer-power b (/ (1- h) 2))))))

(defun gs-count-integer-power (b n)
  (case n
    (0 0)
    (1 (gs-count-factor b) 1)
    (t (incf *gs-muls* (1- n)) (gs-count-base b) 1)))
(defun gs-count-base (b) (if (gs-power-p b) (gs-count-sum b) (gs-count-factor b)))

(defun gs-count-factor (e)
  (cond ((mnump e) (gs-count-number e))
        ((atom e))
        ((or (gs-sum-p e) (gs-product-p e)) (gs-count-sum e))
        ((gs-power-p e)
         (if (gs-divisor-p e)
             (gs-count-product 1 (list e))
             (incf *gs-muls* (1- (gs-count-power (cadr e) (caddr e))))))
        ((eq (caar e) '$gs__decay) (gs-count-decay (cadr e)))
        (t (gs-count-call (caar e))
           (mapc #'gs-count-sum (cdr e)))))

;;; Is a number > 0 printed as the quotient of two constants? A decimal fraction of up to 36 digits
;;; is one constant.
(defun gs-quotient-p (number)
  (let* ((r (gs-exact number)) (q (gs-rational r)))
    (unless (integerp q)
      (let ((d ($gs__finite_decimal r)))
        (not (or (and d (< (cadr d) (expt 10 36)))
                 (>= (numerator q) (expt 2 53))
                 (>= (denominator q) (expt 2 53))))))))
;;; is a factor printed below a fraction line?
(defun gs-divisor-p (power)
  (let ((n (caddr power)))
    (and (mnump n) (gs-negative-p n) (not (eq (cadr power) '$%e)))))
(defun gs-count-call (function)
  (case function
    ((%sqrt $sqrt) (incf *gs-sqrts*))
    ((mabs %abs $abs %signum $max %max $min %min $round %round $gs__floor))
    ($gs__after (incf *gs-adds* 2))
    (t (incf *gs-calls*))))
;;; as fortran/routine.mac writes it: exp(x) + 0/(1 + x^2)
(defun gs-count-decay (x)
  (incf *gs-calls*)
  (incf *gs-muls*)
  (incf *gs-adds* 2)
  (incf *gs-divs*)
  (gs-count-sum x)
  (gs-count-sum x))

;;; how many angles have their sine or cosine among the expressions
(defun $gs__angle_count (expressions)
  (length
    (remove-duplicates
      (loop for e in (cdr expressions)
            when (and (consp e) (member (caar e) '(%sin %cos))) collect (cadr e))
      :test #'alike1)))
