;;; kernel/switches.lisp: which passes are on (kernel/switches.mac has their table).
(in-package :maxima)

(defun gs-on (pass) (member pass (cdr (symbol-value '$gsmbp_passes)) :test #'eq))
;;; whether a pass is on; a word that is no pass is an error
(defun $gs__switched (pass)
  (let ((table (symbol-value '$gs__pass_table)))
    (cond ((gs-on pass) t)
          (($gs__row_of table pass) nil)
          (t (mfuncall '$gs__error "gsmbp_passes" "expected one of "
                       (mfuncall '$gs__words (gs-list (mapcar #'cadr (cdr table)))) "; found: "
                       pass)))))

;;; the passes that are on, as a number: part of the key of what a scene remembers
(defvar *gs-pass-lists* (make-hash-table :test #'equal))
(defun $gs__passes_key ()
  (let* ((passes (symbol-value '$gsmbp_passes)) (l (if (consp passes) (cdr passes) passes)))
    (or (gethash l *gs-pass-lists*)
        (setf (gethash l *gs-pass-lists*) (1+ (hash-table-count *gs-pass-lists*))))))
