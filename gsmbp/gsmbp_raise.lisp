;;; gsmbp_raise.lisp: errors as one line, and what Maxima said when the user's expression could not be evaluated.
(in-package :maxima)

;;; Stops with the text. As Maxima's `error`, but for the list of functions that were being called, which holds their arguments: the whole scene.
;;; Under errcatch and in the debugger it is Maxima's own.
;;; The text is kept as a symbol, as Maxima does.
(defun $gsmbp__raise (text)
  (let ((format (intern (maybe-invert-string-case (gsmbp-tildes text)) :maxima)))
    (when (or errcatch *mdebug*) (merror format))
    (setq $error (list '(mlist simp) format))
    (when $errormsg ($errormsg))
    (fresh-line *standard-output*)
    (format t " -- an error. To debug this try: debugmode(true);~%")
    (throw 'macsyma-quit 'maxima-error)))

(defun gsmbp-tildes (text)
  (with-output-to-string (s)
    (loop for c across text do (when (char= c #\~) (write-char c s)) (write-char c s))))

;;; The text of Maxima's last error on one line; "" if there was none since gsmbp__no_last_error().
(defun $gsmbp__no_last_error () (setq $error '((mlist simp) "")) t)
(defun $gsmbp__last_error ()
  (let ((text (with-output-to-string (*standard-output*) ($errormsg))))
    (string-trim " " (substitute #\Space #\Newline text))))
