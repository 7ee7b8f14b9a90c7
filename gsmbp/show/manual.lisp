;;; show/manual.lisp: what describe (? and ??) and example of Maxima know of GSMBP once it is
;;; loaded. The manual is made by `make doc`, `make install` or `make test`; without it they know
;;; nothing.
(in-package :maxima)

;;; the folder of the manual, with a slash behind it; nil while there is none
(defvar *gs-manual-folder* nil)

;;; Tells describe where the topics of folder/gsmbp.info begin, if the index was made of that very
;;; text: it holds places counted in characters.
(defun $gs__load_manual (folder)
  (flet ((part (name) (probe-file (gs-text folder name))))
    (when (and (part "gsmbp.info") (part "gsmbp-index.lisp")
               (<= (file-write-date (part "gsmbp.info"))
                   (file-write-date (part "gsmbp-index.lisp"))))
      (setq *gs-manual-folder* folder)
      (let ((*load-verbose* nil)) (load (part "gsmbp-index.lisp")))
      t)))

;;; example(NAME) reads GSMBP's file for a name of GSMBP's, Maxima's own otherwise
(defun gs-own-topic-p (topic)
  (let ((name (if (symbolp topic) (symbol-name topic) "")))
    (and *gs-manual-folder* (> (length name) 7) (string-equal "$GSMBP_" name :end2 7))))
(defvar *gs-example* (get '$example 'mfexpr*))
(setf (get '$example 'mfexpr*)
      #'(lambda (form)
          (let (($manual_demo
                 (if (gs-own-topic-p (cadr form)) (gs-text *gs-manual-folder* "gsmbp.demo")
                     $manual_demo)))
            (funcall *gs-example* form))))
