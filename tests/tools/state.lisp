;;; The state of a session of Maxima, for comparison with that of another one: one line for each
;;; symbol, with its value, whether it is a function, and its properties; the file is named by
;;; GSMBP_STATE. Of objects that differ between any two sessions (functions, streams, symbols
;;; without a package) there is the kind only.
(in-package :maxima)

(defvar *state-depth* 0)
(defvar *state-left* 0)     ; how many more objects of a symbol are written
(defvar *state-random* (random (expt 10 20)))   ; states of GCL 2.7 are not printed alike

(defun state-of-parts (kind parts) (format nil "~a(~{~a~^ ~})" kind parts))
(defun state-of-list (l)
  (let ((parts nil))   ; a list may be circular
    (loop repeat 2000 while (consp l) do (push (state-text (pop l)) parts))
    (when (atom l) (push (state-text l) parts))
    (nreverse parts)))
(defun state-of-table (table)
  (let ((entries nil))
    (maphash #'(lambda (k v) (push (state-of-parts "" (mapcar #'state-text (list k v))) entries))
             table)
    (sort entries #'string<)))
(defun state-of-whole (x)
  (cond ((consp x) (state-of-parts "" (state-of-list x)))
        ((hash-table-p x) (state-of-parts "table" (state-of-table x)))
        ((simple-vector-p x) (state-of-parts "vector" (state-of-list (coerce x 'list))))
        ((random-state-p x) "random")
        ((functionp x) "function")
        ((packagep x) (package-name x))
        (t "object")))
(defun state-text (x)
  (when (minusp (decf *state-left*)) (throw 'state-much "much"))
  (cond ((symbolp x) (if (symbol-package x) (prin1-to-string x) "symbol"))
        ((and (stringp x) (> (length x) 10000)) "long")
        ((or (numberp x) (characterp x) (stringp x) (pathnamep x)) (prin1-to-string x))
        ((> *state-depth* 8) "deep")   ; what holds itself, too
        (t (let ((*state-depth* (1+ *state-depth*))) (state-of-whole x)))))

(defun state-of-symbol (s)
  (format nil "~a: ~a, ~:[no~;a~] function, ~a" (prin1-to-string s)
          (if (boundp s) (state-text (symbol-value s)) "no value")
          (fboundp s) (state-text (symbol-plist s))))
(defun state-line (s)
  (let ((*state-left* 300000))   ; some values of GCL cannot be read
    (catch 'state-much (ignore-errors (state-of-symbol s)))))
(defun state-lines ()
  (let ((found nil) (*print-length* nil) (*print-level* nil) (*print-pretty* nil)
        (*package* (find-package :keyword)))
    (dolist (p (list-all-packages))
      (do-symbols (s p)
        (when (eq (symbol-package s) p) (push (state-line s) found))))
    (sort (remove nil found) #'string<)))

(with-open-file (out (maxima-getenv "GSMBP_STATE") :direction :output :if-exists :supersede)
  (dolist (line (state-lines)) (write-line (substitute #\space #\newline line) out)))
