;;; text/language.lisp: what a printer of a programming language has to say for itself.
;;;
;;; The printer of expressions and statements (fortran/expressions.lisp, fortran/statements.lisp)
;;; puts operands in order, names what is new and counts; what it needs to know of the language it
;;; asks by a word. A folder for each language answers with one function a word:
;;;
;;;   word         arguments              is
;;;   :cased       text                   a name in the case of the language
;;;   :base        text                   a name that a variable may have, of any text
;;;   :constant    n k                    n/10^k as a constant
;;;   :power       b n                    b to the whole power n > 1, where a factor is wanted
;;;   :general     b n                    b to any other power
;;;   :root        b                      its square root
;;;   :exponential n                      %e to the power n
;;;   :call        f texts                the function f of Maxima of arguments that are texts
;;;   :above       text                   a product as the first part of a term
;;;   :load        name source            the line that loads a name from a place
;;;   :assign      target pieces own      lines of an assignment; own: the target is not declared yet
;;;   :most        none                   how many lines of an assignment are too many; or nil
;;;   :sines       angle names own        lines that give sine and cosine of an angle two names, of
;;;                                       which own are not declared yet
;;;   :block       heading                comment lines ahead of a block
;;;   :given       text                   lines of a statement that is text
(in-package :maxima)

;;; the language that is being printed: fortran or c
(defvar $gs__language '$fortran)
;;; language -> its answers, a property list
(defvar *gs-printers* nil)

(defun gs-set-printer (language &rest answers) (setf (getf *gs-printers* language) answers))
(defun gs-say (word &rest arguments)
  (apply (getf (getf *gs-printers* $gs__language) word) arguments))
(defun $gs__cased (text) (gs-say :cased text))
