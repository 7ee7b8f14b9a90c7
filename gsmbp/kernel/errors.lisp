;;; kernel/errors.lisp: errors as one line; what Maxima said of an expression of the user's.
(in-package :maxima)

;;; Stops with the text. As Maxima's `error`, but for the list of functions that were being called,
;;; which holds their arguments: the whole scene.
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

;;; Stops at the first of the elements, as typed, that Maxima cannot simplify: mass = 1/0, sin(q,
;;; q).
(defun gsmbp-need-simple (elements)
  (let* ((e (find-if-not #'gsmbp-simplifies elements)) (option (and e (eq (caar e) 'mequal))))
    (when e
      (let ((part (if option (caddr e) (or (find-if-not #'gsmbp-simplifies (cdr e)) e))))
        ($gsmbp__no_last_error)
        (gsmbp-simplifies part)
        ($gsmbp__raise
          (format nil
                  "gsmbp_scene: ~:[~a ~;~*~]~a: expected values that can be worked out; ~
                   found: ~a (~a)"
                  option (gsmbp-as-written (caar e)) (gsmbp-as-written (cadr e))
                  (gsmbp-as-written part) ($gsmbp__last_error)))))))
(defvar gsmbp-tried nil)
(defun $gsmbp__try_to_simplify () (simplify (copy-tree gsmbp-tried)) t)
(defun gsmbp-simplifies (e)
  (or (atom e)
      (let (($errormsg nil) (gsmbp-tried e))
        (and (cdr (meval '(($errcatch) (($gsmbp__try_to_simplify))))) t))))
(defun gsmbp-as-written (e) (coerce (mstring e) 'string))
