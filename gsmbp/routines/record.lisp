;;; routines/record.lisp: what is in the record of a routine (routines/record.mac), whose places and
;;; statements can be thousands.
(in-package :maxima)

;;; is it a routine for many states at once?
(defun $gs__batchp (r)
  (let* ((suffix ($@-function r '$suffix)) (n (length suffix)))
    (and (> n 2)
         (member (subseq suffix (- n 2)) '("_V" "_W") :test #'string=)
         t)))

;;; the statements inside a statement
(defun $gs__inner_statements (s)
  (if (or ($gs__is_struct s '$gs__looping) ($gs__is_struct s '$gs__testing))
      ($@-function s '$body_)
      (gs-list nil)))
;;; an entry [false, statement, block] of the code as its statement
(defun $gs__bare_statement (s) (if (and ($listp s) (null (cadr s))) (caddr s) s))
;;; statements and entries with all that is inside them, one behind the other
(defun $gs__all_statements (l) (gs-list (gs-all-statements (cdr l))))
(defun gs-all-statements (l)
  (loop for x in l
        append (let ((s ($gs__bare_statement x)))
                 (if ($listp s)
                     (list s)
                     (cons s (gs-all-statements (cdr ($gs__inner_statements s))))))))
;;; the statements among the code, and those around it
(defun $gs__statements_of (r)
  (flet ((part (field) (cdr ($@-function r field))))
    (gs-list (append (part '$before)
                     (loop for c in (part '$code) when (null (cadr c)) collect (caddr c))
                     (part '$after)))))

;;; the expressions that a statement holds, not those of its inner statements
(defun $gs__expressions_in (s)
  (flet ((parts (&rest fields) (mapcar #'(lambda (f) ($@-function s f)) fields)))
    (gs-list (case (caar s)
               (mlist (list (cadr s) (caddr s)))
               ($gs__setting (parts '$place '$value_))
               ($gs__calling (cdr ($@-function s '$arguments_)))
               ($gs__looping (parts '$index_ '$first_ '$last_))
               ($gs__testing (parts '$test_))))))
;;; whether some statement holds the word of a function or test, gs__fn(word, ...)
(defun $gs__says (word statements)
  (loop for s in (gs-all-statements (cdr statements))
        thereis (some #'(lambda (e) (gs-holds-word-p word e)) (cdr ($gs__expressions_in s)))))
(defun gs-holds-word-p (word e)
  (and (consp e)
       (or (and (member (caar e) '($gs__fn_ $gs__rel_)) (equal (cadr e) word))
           (some #'(lambda (x) (gs-holds-word-p word x)) (cdr e)))))

;;; the loads [symbol, place] whose symbol an expression of the code or a result uses
(defun $gs__loads_used (loads code result)
  (let ((used (make-hash-table :test #'eq)))
    (dolist (row (append (cdr code) (cdr result)))
      (dolist (s (cdr ($gs__symbols (caddr row)))) (setf (gethash s used) t)))
    (gs-list (remove-if-not #'(lambda (l) (gethash (cadr l) used)) (cdr loads)))))
;;; how many entries of the code, from its start on, are sines and cosines in pairs
(defun $gs__leading_calls (code)
  (or (position-if-not #'$listp (cdr code) :key #'cadr) (length (cdr code))))
;;; what stands above the values of an array whose text this is
(defun $gs__title_of (text)
  (subseq text 0 (position-if #'(lambda (c) (find c ";:")) text)))
;;; [] => "", ["LDM", "*"] => "(LDM,*)"; an entry [0, 3] is 0:3
(defun $gs__dimension_text (dims)
  (flet ((shown (d) (if ($listp d) (gs-joined (mapcar #'$sconcat (cdr d)) ":") ($sconcat d))))
    (if (null (cdr dims)) "" (gs-text "(" (gs-joined (mapcar #'shown (cdr dims)) ",") ")"))))
