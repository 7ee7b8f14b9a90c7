;;; routines/statements.lisp: the words of the language of routines/statements.mac: each makes a
;;; structure of that file from its parts.
(in-package :maxima)

(defun gs-made (kind &rest parts) (cons (list kind 'simp) parts))
(defun $gs__set (place value) (gs-made '$gs__setting place value))
(defun $gs__call (name arguments) (gs-made '$gs__calling name arguments))
(defun $gs__loop (index last body) ($gs__states_loop index 1 last 1 '$once body))
(defun $gs__states_loop (index start end every kind body)
  (gs-made '$gs__looping index start end every kind body))
(defun $gs__when (test body) (gs-made '$gs__testing test body nil))
(defun $gs__as_a_rule (test body) (gs-made '$gs__testing test body t))
(defun $gs__note_line (text) (gs-made '$gs__noting text))
(defun $gs__return () (gs-made '$gs__returning "plain"))
(defun $gs__reals (&rest names) (gs-made '$gs__declaring "real" (gs-list names)))
(defun $gs__wholes (&rest names) (gs-made '$gs__declaring "whole" (gs-list names)))
(defun $gs__uses (&rest names) (gs-made '$gs__using (gs-list names)))

(defun $gs__el (name &rest subscripts) (list* '($gs__el_ simp) name subscripts))
(defun $gs__fn (name &rest arguments) (list* '($gs__fn_ simp) name arguments))
(defun $gs__condition (word &rest operands) (list* '($gs__rel_ simp) word operands))
(defun $gs__double (x) (gs-made '$gs__num_ x))

;;; the name of the array, or number, of a place
(defun $gs__held_in (place) (if (stringp place) place (cadr place)))

;;; leave where a test holds; INFO becomes a number, always or where a test holds
(defun $gs__leave_if (test) ($gs__when test (gs-list (list ($gs__return)))))
(defun $gs__set_info (number) ($gs__set "INFO" number))
(defun $gs__bad_if (test number) ($gs__when test (gs-list (list ($gs__set_info number)))))
