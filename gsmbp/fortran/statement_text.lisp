;;; fortran/statement_text.lisp: the places, expressions and tests of routines/statements.mac as
;;; text of Fortran 77 (a routine has thousands of places).
(in-package :maxima)

;;; whether a number is finite is asked of GSFIN; the others are functions of Fortran
(defvar *gs-fortran-functions*
  '(("abs" . "ABS") ("max" . "MAX") ("nearest" . "NINT") ("not_finite" . "GSFIN")
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
        ((eq (caar x) '$gs__fn_)
         (gs-text (gs-word-in *gs-fortran-functions* (cadr x))
                  "( " (gs-joined (gs-value-texts (cddr x)) ", ") " )"))
        ((gs-sum-p x) (gs-sum-of-texts (gs-value-texts (cdr x))))
        (t (gs-product-of-texts (cdr x)))))
(defun gs-value-texts (l) (mapcar #'$gs__value_text l))
(defun gs-compact-text (x) (remove #\Space ($gs__value_text x)))

(defun gs-sum-of-texts (texts)
  (flet ((signed (s)
           (if (char= (char s 0) #\-) (gs-text " - " (subseq s 1)) (gs-text " + " s))))
    (gs-joined (cons (car texts) (mapcar #'signed (cdr texts))) "")))
(defun gs-product-of-texts (factors)
  (if (eql (car factors) -1)
      (gs-text "-" (gs-product-of-texts (cdr factors)))
      (gs-joined (gs-value-texts factors) "*")))

;;; a place or a real constant as text; what is neither, a symbol of the code, stays
(defun $gs__place_text (place)
  (if (and (consp place) (member (caar place) '($gs__el_ $gs__num_)))
      ($gs__value_text place)
      place))
;;; rows of a list with their k-th part as such a text
(defun $gs__with_place_texts (rows k)
  (flet ((written (row)
           (let ((r (copy-list row))) (setf (nth k r) ($gs__place_text (nth k r))) r)))
    (gs-list (mapcar #'written (cdr rows)))))

;;; [] => "", ["LDM", "*"] => "(LDM,*)"; an entry [0, 3] is 0:3
(defun $gs__dimension_text (dims)
  (cond ((not ($listp dims)) dims)
        ((null (cdr dims)) "")
        (t (gs-text "(" (gs-joined (mapcar #'gs-range-text (cdr dims)) ",") ")"))))
(defun gs-range-text (d)
  (if ($listp d) (gs-joined (gs-value-texts (cdr d)) ":") ($sconcat d)))

;;; gs__condition("<", a, b), ("within", a), ("and", p, q), ...
(defun $gs__test_text (p)
  (destructuring-bind (word &rest operands) (cdr p)
    (cond ((string= word "not") (gs-text ".NOT.( " ($gs__test_text (car operands)) " )"))
          ((string= word "and") (gs-joined (mapcar #'$gs__test_text operands) " .AND. "))
          ((string= word "or") (gs-joined (mapcar #'$gs__test_text operands) " .OR. "))
          ((string= word "within") (gs-text "ABS(" ($gs__value_text (car operands)) ").LE.BIG"))
          (t (gs-text ($gs__value_text (car operands)) (gs-word-in *gs-fortran-relations* word)
                      ($gs__value_text (cadr operands)))))))
