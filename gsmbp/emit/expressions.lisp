;;; emit/expressions.lisp: expressions as text: sums, terms, factors. What a programming language
;;; decides is asked of its record (emit/language.mac).
(in-package :maxima)

;;; --------------------------------------------------------------------------- sums, terms, factors

;;; any expression: a sum with a positive term ahead if it has one
(defun $gs__sum_text (e)
  (if (symbolp e)
      (gs-name-text e)
      (gs-joined (cdr ($gs__signed_pieces ($gs__signed_terms e))) "")))

;;; the summands of e (one, if e is no sum) as [sign, text, summand], sign "+" or "-"; the first
;;; positive one ahead
(defun $gs__signed_terms (e)
  (if (not (gs-sum-p e))
      (gs-list (list (gs-signed-term e)))
      (let* ((terms (mapcar #'gs-signed-term (gs-as-ready (cdr e))))
             (lead (loop for x in terms when (string= (cadr x) "+") return x)))
        (gs-list
          (if (or (null lead) (eq lead (car terms)))
              terms
              (cons lead (remove lead terms :test #'eq)))))))

;;; terms as pieces of text: "A", " + B*C", " - D"
(defun $gs__signed_pieces (terms)
  (destructuring-bind (first &rest others) (cdr terms)
    (gs-list (cons (if (string= (cadr first) "-") (gs-text "-" (caddr first)) (caddr first))
                   (mapcar #'(lambda (x) (gs-text " " (cadr x) " " (caddr x))) others)))))

(defun gs-signed-term (e)
  (cond ((symbolp e) (gs-list (list "+" (gs-name-text e) e)))
        ((mnump e) (gs-signed e (gs-number-text (gs-magnitude e)) e))
        ((gs-product-p e)
         (let ((c (cadr e)))
           (if (mnump c)
               (gs-signed c (gs-product-text (gs-magnitude c) (cddr e)) e)
               (gs-signed 1 (gs-product-text 1 (cdr e)) e))))
        (t (gs-signed
             1 (if (gs-power-p e) (gs-product-text 1 (list e)) (gs-factor-text e)) e))))
(defun gs-signed (number text e)
  (gs-list (list (if (gs-negative-p number) "-" "+") text e)))

;;; a number >= 0 as constants: one, or two whose quotient it is; as a term
(defun gs-number-parts (r)
  (cdr (or (gethash r $gs__numbers)
           (setf (gethash r $gs__numbers) (mfuncall '$gs__constants (gs-exact r))))))
(defun gs-number-text (r) (gs-joined (gs-number-parts r) "/"))
(defun gs-one () (car (gs-number-parts 1)))

;;; a number c > 0 times factors; powers with a negative exponent become divisors
(defun gs-product-text (c factors)
  (let ((above nil) (below nil))
    (dolist (f (gs-as-ready factors))
      (cond ((symbolp f) (push (gs-name-text f) above))
            ((not (gs-power-p f)) (push (gs-factor-text f) above))
            ((and (mnump (caddr f)) (gs-negative-p (caddr f)) (not (eq (cadr f) '$%e)))
             (setq below (append (gs-power-texts (cadr f) (gs-minus (caddr f))) below)))
            (t (setq above (append (gs-power-texts (cadr f) (caddr f)) above)))))
    (if (eql c 1) (gs-fraction-text (reverse above) (reverse below))
      (gs-scaled-text (gs-exact c) (reverse above) (reverse below)))))

;;; the same with texts of the factors: a decimal fraction is a factor, 1/3 a divisor, 2/3 a factor
;;; (2.0/3.0)
(defun gs-scaled-text (c above below)
  (let ((k (gs-number-parts c)))
    (cond ((eql c 1) (gs-fraction-text above below))
          ((null (cdr k)) (gs-fraction-text (cons (car k) above) below))
          ((eql (cadr c) 1) (gs-fraction-text above (cons (cadr k) below)))
          (below (gs-fraction-text (cons (car k) above) (cons (cadr k) below)))
          (t (gs-fraction-text (cons (gs-text "(" (car k) "/" (cadr k) ")") above) nil)))))

(defun gs-fraction-text (above below)
  (let ((text (if above (gs-factors-text above) (gs-one))))
    (cond ((null below) text)
          ((cdr below) (gs-text text "/(" (gs-joined below "*") ")"))
          (t (gs-text text "/" (car below))))))

(defun gs-factors-text (texts)
  (gs-joined (cons (gs-said '$leading (car texts)) (cdr texts)) "*"))

;;; b^n as factors in reverse order; n > 0 if it is a number.  Roots of the order 4 are square roots
;;; of square roots, which are faster than powers and as accurate
(defun gs-power-texts (b n)
  (if (eq b '$%e)
      (list (gs-called '%exp (list n)))
      (let ((q (if (mnump n) (gs-times 4 (gs-exact n)))))
        (cond ((not (integerp q)) (list (gs-said '$raised b n)))
              ((evenp q) (gs-root-texts b (/ q 2)))
              (t (cons (gs-called '%sqrt (list (list '(mexpt simp) b '((rat simp) 1 2))))
                       (gs-root-texts b (/ (1- q) 2))))))))

;;; b^(h/2) so
(defun gs-root-texts (b h)
  (if (evenp h)
      (gs-integer-power b (/ h 2))
      (cons (gs-called '%sqrt (list b)) (gs-integer-power b (/ (1- h) 2)))))

(defun gs-integer-power (b n)
  (case n
    (0 nil)
    (1 (list (gs-factor-text b)))
    (t (list (gs-said '$power b n)))))
;;; a base or an exponent, in parentheses if it is not one factor
(defun $gs__base_text (b)
  (if (gs-power-p b) (gs-text "(" ($gs__sum_text b) ")") (gs-factor-text b)))
(defun $gs__factor_text (e) (gs-factor-text e))

(defun gs-factor-text (e)
  (cond ((mnump e) (gs-number-factor e))
        ((atom e) (gs-name-text e))
        ((or (gs-sum-p e) (gs-product-p e)) (gs-text "(" ($gs__sum_text e) ")"))
        ((gs-power-p e) (gs-power-factor (cadr e) (caddr e) e))
        (t (gs-called ($op e) (cdr e)))))

;;; a call of a function with its arguments, as the language calls it
(defun gs-called (f arguments)
  (let ((e (mfuncall '$assoc f (gs-said-of '$functions))) (n (length arguments)))
    (unless e (mfuncall '$gs__error $gs__where (gs-said-of '$name) " has no function " f))
    (destructuring-bind (name arity) (cdr e)
      (when (if (eql arity 0) (< n 2) (/= n arity))
        (mfuncall '$gs__error $gs__where "wrong number of arguments of " f ": " n))
      (gs-said '$called name (gs-list (mapcar #'$gs__sum_text arguments))))))

(defun gs-number-factor (e)
  (let ((s (gs-number-text (gs-magnitude e))))
    (cond ((gs-negative-p e) (gs-text "(-" s ")"))
          ((cdr (gs-number-parts (gs-magnitude e))) (gs-text "(" s ")"))
          (t s))))

;;; a power where one factor is wanted: x^2, sqrt(x) and exp(x) are one; 1/x and x*sqrt(x) need
;;; parentheses
(defun gs-power-factor (b n e)
  (if (and (mnump n) (gs-negative-p n) (not (eq b '$%e)))
      (gs-text "(" (gs-product-text 1 (list e)) ")")
      (let ((l (gs-power-texts b n)))
        (if (cdr l) (gs-text "(" (gs-factors-text (reverse l)) ")") (car l)))))
