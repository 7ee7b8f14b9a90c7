;;; kernel/statements.lisp: the statements of the .mac files as Maxima has read them. To read them
;;; takes Maxima longer than all else that loading does; share/make/compile does it once and leaves
;;; them beside the compiled Lisp files (kernel/compiled.mac), each file's with its name.
(in-package :maxima)

;;; A source of Lisp loaded; SBCL warns of every function that comes in a later one.
(defun $gs__load_lisp_file (file)
  (handler-bind ((style-warning #'muffle-warning)) ($load file)))

;;; name of a file, without .mac -> its size and its statements, and the time of the file that held
;;; them
(defvar *gs-statements* nil)
(defvar *gs-statements-time* 0)

(defmacro gs-with-plain-syntax (&body body)
  `(let ((*package* (find-package :maxima))
         (*print-pretty* nil)
         (*print-level* nil)
         (*print-length* nil)
         (*print-circle* nil)
         (*print-base* 10)
         (*print-radix* nil)
         (*print-case* :upcase)
         (*print-escape* t)
         (*read-base* 10)
         (*read-default-float-format* 'double-float))
     ,@body))

(defun gs-file-size (path) (with-open-file (in path) (file-length in)))
;;; the sizes of the Lisp files when they were compiled, in their order: share/make/compile sets it
(defvar *gs-compiled-sizes* nil)
(defun $gs__as_compiled (paths) (equal (mapcar #'gs-file-size (cdr paths)) *gs-compiled-sizes*))

(defun gs-source (here name) (concatenate 'string here name ".mac"))
;;; an expression without the places in its file that Maxima notes in it, ((op (line file src)) ...)
(defun gs-without-places (e)
  (flet ((place-p (x) (and (consp x) (eq (car (last x)) 'src))))
    (cond ((atom e) e)
          (t (loop for x in e unless (place-p x) collect (gs-without-places x))))))
(defun gs-statements-of (path)
  (with-open-file (in path)
    (loop for form = (mread-raw in in)
          until (eq form in) collect (gs-without-places (third form)))))

;;; the statements of the files of the list `names` below the folder `here`, as the file `path`; its
;;; last form tells that it is whole
(defun $gs__write_statements (here names path)
  (with-open-file (out path :direction :output :if-exists :supersede)
    (gs-with-plain-syntax
      (dolist (name (cdr names))
        (let ((path (gs-source here name)))
          (prin1 (list* name (gs-file-size path) (gs-statements-of path)) out))
        (terpri out))
      (prin1 :whole out)))
  '$done)

(defun gs-whole-p (in)
  (let ((n (- (file-length in) (length ":WHOLE"))))
    (and (plusp n)
         (file-position in n)
         (equal (read-line in nil) ":WHOLE")
         (file-position in 0))))

;;; none of a file that a full disk has cut short
(defun $gs__read_statements (path)
  (setq *gs-statements* nil *gs-statements-time* 0)
  (when (probe-file path)
    (with-open-file (in path)
      (when (gs-whole-p in)
        (setq *gs-statements*
                (gs-with-plain-syntax
                  (loop for form = (read in) until (eq form :whole) collect form))
              *gs-statements-time* (file-write-date path)))))
  '$done)

;;; gs__load_source(here, name): the file `name`.mac of the folder `here`, its statements as they
;;; were read before if it has not changed since
(defun $gs__load_source (here name)
  (let* ((path (gs-source here name))
         (known (assoc name *gs-statements* :test #'string=)))
    (if (and known
             (< (file-write-date path) *gs-statements-time*)
             (= (gs-file-size path) (cadr known)))
        (mapc #'meval* (cddr known))
        ($load path))
    '$done))
;;; The files of the list `names`. Maxima looks up each function that it defines in its list
;;; `functions`; with 4000 of them that takes longer than all other steps of loading. So each file
;;; begins with an empty list, and the lists are joined at the end, after an error, too.
(defun $gs__load_sources (here names)
  (let ((before $functions) (new nil))
    (unwind-protect
        (dolist (name (cdr names) '$done)
          (let (($functions (list (car before))))
            (unwind-protect ($gs__load_source here name)
              (setq new (revappend (cdr $functions) new)))))
      (setq $functions (gs-functions-joined before new)))))
;;; the list `before` with the functions of `new`, the last of which comes first
(defun gs-functions-joined (before new)
  (let ((listed (make-hash-table :test 'eq)) (joined nil))
    (flet ((add (f)
             (unless (gethash (caar f) listed)
               (setf (gethash (caar f) listed) t)
               (push f joined))))
      (mapc #'add new)
      (mapc #'add (reverse (cdr before))))
    (cons (car before) joined)))
