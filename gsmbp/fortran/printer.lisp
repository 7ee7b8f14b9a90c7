;;; fortran/printer.lisp: what Fortran 77 has to say for itself (text/language.lisp).
(in-package :maxima)

(defun gs-fortran-constant (n k)
  (let ((text ($gs__decimal_text n k "D")))
    (if (find #\D text) text (gs-text text "D0"))))
(defun gs-fortran-call (name texts)
  (gs-text name (if (string= name "SIGN") "(1.0D0, " "(") (gs-joined texts ", ") ")"))

;;; a statement of fixed form takes 20 lines at most
(gs-set-printer '$fortran
  :cased #'string-upcase
  :base #'(lambda (text) (let ((n (gs-plain-name text))) (subseq n 0 (min 26 (length n)))))
  :constant #'gs-fortran-constant
  :power #'(lambda (b n) (gs-text (gs-base-text b) "**" (format nil "~d" n)))
  :general #'(lambda (b n) (gs-text (gs-base-text b) "**" (gs-factor-text n)))
  :root #'(lambda (b) (gs-text "SQRT(" ($gs__sum_text b) ")"))
  :exponential #'(lambda (n) (gs-text "EXP(" ($gs__sum_text n) ")"))
  :call #'gs-fortran-call
  :above #'identity
  :load #'(lambda (name source) ($gs__own_name name) (gs-text "      " name " = " source))
  :assign #'(lambda (target pieces own)
              (declare (ignore own))
              ($gs__packed_lines
                (gs-list (cons (gs-text target " = " (cadr pieces)) (cddr pieces)))))
  :most #'(lambda () 20)
  :sines #'(lambda (angle names own)
             (declare (ignore own))
             ($gs__packed_lines
               (gs-list
                 (list (gs-text "CALL GSSC( " angle ", ") (car names) ", " (cadr names) " )"))))
  :block #'(lambda (heading) ($gs__filled heading "C     -- " "C        "))
  :given #'(lambda (text) (mfuncall '$gs__raw_lines text)))
