;;; emit/language.lisp: the state of an emission, held in variables of Maxima, and what the record
;;; of a programming language says (emit/language.mac).
(in-package :maxima)

(declaim
  (special $gs__language $gs__names $gs__used $gs__delays $gs__numbers $gs__body $gs__block $gs__own
           $gs__where $gs__occupied $gs__parts $gs__declares $gs__indent))

; hash table, symbol -> source: those that are loaded ahead of the first statement that uses them;
; or false
(defvar $gs__late nil)
; (name . source) of those that wait for the next statement; bound by gs__emission, as all that an
; interrupt must not leave behind
(defvar $gs__due nil)

;;; what the language's record says, and what its function there makes of arguments
(defun gs-said-of (field)
  (nth (position field (cdr (get '$gs__language 'defstruct-template))) (cdr $gs__language)))
(defun gs-said (field &rest arguments) (apply #'mfuncall (gs-said-of field) arguments))
