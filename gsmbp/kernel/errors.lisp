;;; kernel/errors.lisp: errors as one line; what Maxima said of an expression of the user's.
(in-package :maxima)

;;; Stop with the text. As Maxima's `error`, but for the list of functions that were being called,
;;; which holds their arguments: the whole scene.
;;; Under errcatch and in the debugger it is Maxima's own.
;;; The text is kept as a symbol, as Maxima does.
(defun $gs__raise (text)
  (gs-raise (intern (maybe-invert-string-case (gs-tildes text)) :maxima)))
(defvar *gs-raised* nil)              ; the last text
(defun gs-raise (format)
  (setq *gs-raised* format)
  (when (or errcatch *mdebug*) (merror format))
  (setq $error (list '(mlist simp) format))
  (when $errormsg ($errormsg))
  (fresh-line *standard-output*)
  (format t " -- an error. To debug this try: debugmode(true);~%")
  (throw 'macsyma-quit 'maxima-error))

(defun gs-tildes (text)
  (with-output-to-string (s)
    (loop for c across text do (when (char= c #\~) (write-char c s)) (write-char c s))))

;;; Is the last error one of GSMBP's?
(defun $gs__raised_last () (and *gs-raised* (eq (cadr $error) *gs-raised*)))

;;; The value of f(), the work of a public function: an error of Maxima's own in it becomes one of
;;; GSMBP that names the function and the scene, `who`. Errors of Lisp stay what they are; so do all
;;; while Maxima's debugger is on.
(defvar *gs-clear* nil)
(defun gs-clear-errors (who f)
  (if (or *gs-clear* *mdebug*)
      (funcall f)
      (let* ((mark (cons bindlist loclist)) (failed nil)
             (value (let ((*gs-clear* t) ($errormsg nil) (errcatch mark))
                      (handler-case (funcall f) (maxima-$error () (setq failed t))))))
        (when failed
          (errlfun1 mark)
          (gs-raise-clear who))
        value)))
(defun gs-raise-clear (who)
  (if ($gs__raised_last)
      (gs-raise *gs-raised*)
      (let ((text (string-right-trim "." ($gs__last_error))))
        ($gs__raise
          (cond
            ((or (search "undefined" text) (search "by zero" text) (search "log" text))
             (format nil "~a: expected expressions that have a value; found: ~a; remedy: look for ~
                          a divisor, or an argument of a logarithm, that is always 0" who text))
            (t
             (format nil "~a: expected expressions that have a value; found: ~a; remedy: this is ~
                          a fault of GSMBP, debugmode(true) shows where" who text)))))))

;;; The text of Maxima's last error on one line; "" if there was none since gs__no_last_error().
(defun $gs__no_last_error () (setq $error '((mlist simp) "")) t)
(defun $gs__last_error ()
  (let ((text (with-output-to-string (*standard-output*) ($errormsg))))
    (string-trim " " (substitute #\Space #\Newline text))))

;;; Stops at the first of the elements, as typed, that Maxima cannot simplify: mass = 1/0, sin(q,
;;; q).
(defun gs-need-simple (elements)
  (let* ((e (find-if-not #'gs-simplifies elements)) (option (and e (eq (caar e) 'mequal))))
    (when e
      (let ((part (if option (caddr e) (or (find-if-not #'gs-simplifies (cdr e)) e))))
        ($gs__no_last_error)
        (gs-simplifies part)
        ($gs__raise
          (format nil
                  "gsmbp_scene: ~:[~a ~;~*~]~a: expected values that can be worked out; ~
                   found: ~a (~a)"
                  option (gs-as-written (caar e)) (gs-as-written (cadr e))
                  (gs-as-written part) ($gs__last_error)))))))
;;; Stops at the first of the elements, as typed, that holds an assignment where name = value should
;;; stand: link(a, mass : 3), parameters = [m : 1*kg]. Nothing is assigned.
(defun gs-need-no-assignment (elements)
  (let* ((e (find-if #'gs-assigned-in elements)) (part (gs-assigned-in e)))
    (when e
      ($gs__raise
        (format nil "gsmbp_scene: ~@[~a: ~]expected name = value; found: ~a, which assigns"
                (cond ((eq e part) nil)
                      ((eq (caar e) 'mequal) (gs-as-written (cadr e)))
                      (t (format nil "~a ~a" (gs-as-written (caar e)) (gs-as-written (cadr e)))))
                (gs-as-written part))))))
(defun gs-assigned-in (e) (or (gs-assigned e) (and (consp e) (some #'gs-assigned (cdr e)))))
(defun gs-assigned (e)
  (cond ((atom e) nil)
        ((member (caar e) '(msetq mset mdefine mdefmacro)) e)
        ((member (caar e) '(mlist mequal)) (some #'gs-assigned (cdr e)))))
(defvar gs-tried nil)
(defun $gs__try_to_simplify () (simplify (copy-tree gs-tried)) t)
(defun gs-simplifies (e)
  (or (atom e)
      (let (($errormsg nil) (gs-tried e))
        (and (cdr (meval '(($errcatch) (($gs__try_to_simplify))))) t))))
(defun gs-as-written (e) (coerce (mstring e) 'string))
