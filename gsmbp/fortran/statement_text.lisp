;;; fortran/statement_text.lisp: the places, expressions and tests of routines/statements.mac as
;;; text of Fortran 77.
(in-package :maxima)

;;; whether a number is finite is asked of GSFIN; the others are functions of Fortran
(defvar *gs-fortran-functions*
  '(("abs" . "ABS") ("max" . "MAX") ("min" . "MIN") ("nearest" . "NINT") ("not_finite" . "GSFIN")
    ("epsilon" . "GSEPS")))
(defvar *gs-fortran-relations*
  '(("<" . ".LT.") ("<=" . ".LE.") ("=" . ".EQ.") ("/=" . ".NE.") (">" . ".GT.") (">=" . ".GE.")))
(defun gs-word-in (table word) (cdr (assoc word table :test #'string=)))

;;; a text, a whole number, a place, a function, a real constant; sums and products of these
(defun $gs__value_text (x)
  (cond ((stringp x) x)
        ((integerp x) (format nil "~d" x))
        ((eq (caar x) '$gs__num_) (gs-joined (cdr (mfuncall '$gs__constants (cadr x))) "/"))
        ((eq (caar x) '$gs__el_)
         (gs-text (cadr x) "(" (gs-joined (mapcar #'gs-compact-text (cddr x)) ",") ")"))
        ((eq (caar x) '$gs__fn_) (gs-function-text (cadr x) (gs-value-texts (cddr x))))
        ((gs-sum-p x) (gs-sum-of-texts (gs-value-texts (cdr x))))
        ((gs-product-p x) (gs-product-of-texts (cdr x)))
        ((gs-power-p x)
         (gs-text (gs-factor-of-text (cadr x)) "**" (gs-factor-of-text (caddr x))))
        (t (mfuncall '$gs__error (symbol-value '$gs__where) "a statement holds " x
                     ", which is no expression there"))))
(defun gs-value-texts (l) (mapcar #'$gs__value_text l))
(defun gs-compact-text (x) (remove #\Space ($gs__value_text x)))
(defun gs-function-text (word texts)
  (if (string= word "quotient")
      (gs-text "( " (car texts) " )/" (cadr texts))
      (gs-text (gs-word-in *gs-fortran-functions* word) "( " (gs-joined texts ", ") " )")))

;;; the sum of terms, one without a minus ahead
(defun gs-minus-ahead-p (text) (char= (char text 0) #\-))
(defun $gs__sum_of_texts (texts) (gs-sum-of-texts (cdr texts)))
(defun gs-sum-of-texts (texts)
  (let* ((lead (or (find-if-not #'gs-minus-ahead-p texts) (car texts)))
         (others (remove lead texts :test #'string= :count 1)))
    (flet ((signed (s)
             (if (gs-minus-ahead-p s) (gs-text " - " (subseq s 1)) (gs-text " + " s))))
      (gs-joined (cons lead (mapcar #'signed others)) ""))))
(defun gs-product-of-texts (factors)
  (if (eql (car factors) -1)
      (gs-text "-" (gs-product-of-texts (cdr factors)))
      (gs-joined (mapcar #'gs-factor-of-text factors) "*")))
(defun gs-factor-of-text (x)
  (if (gs-sum-p x) (gs-text "( " ($gs__value_text x) " )") ($gs__value_text x)))

;;; gs__condition("<", a, b), ("within", a), ("and", p, q), ...
(defun $gs__test_text (p)
  (destructuring-bind (word &rest operands) (cdr p)
    (cond ((string= word "not") (gs-text ".NOT.( " ($gs__test_text (car operands)) " )"))
          ((string= word "and") (gs-joined (mapcar #'$gs__test_text operands) " .AND. "))
          ((string= word "or") (gs-joined (mapcar #'$gs__test_text operands) " .OR. "))
          ((string= word "within") (gs-text "ABS(" ($gs__value_text (car operands)) ").LE.BIG"))
          (t (gs-text ($gs__value_text (car operands)) (gs-word-in *gs-fortran-relations* word)
                      ($gs__value_text (cadr operands)))))))
