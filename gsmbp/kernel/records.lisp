;;; kernel/records.lisp: structures made by the names of their fields.
(in-package :maxima)

;;; gs__record(structure, field = value, ...) is a new structure. A field that is left out has
;;; the default that defstruct gives it; one without a default, and a field that the structure does
;;; not have, is an error. The call turns itself into new(structure(values in order)) when it is met
;;; first, so that it costs no more than that.
(defmspec $gs__record (form)
  (let ((made (gs-by-position (cadr form) (cddr form))))
    (setf (car form) (list '$new) (cdr form) (list made))
    (meval form)))

(defun gs-by-position (structure given)
  (let ((fields (cdr (get structure 'defstruct-template)))
        (defaults (cdr (get structure 'defstruct-default))))
    (dolist (g given) (gs-need-field structure fields g))
    (cons (list structure)
          (mapcar #'(lambda (field default)
                      (let ((g (find field given :key #'cadr)))
                        (cond (g (caddr g))
                              ((eq field default)
                               (gs-record-error structure "no value for the field" field))
                              (t default))))
                  fields defaults))))

(defun gs-need-field (structure fields g)
  (unless (and (consp g) (eq (caar g) 'mequal))
    (gs-record-error structure "expected field = value; found:" g))
  (unless (member (cadr g) fields)
    (gs-record-error structure "there is no field" (cadr g))))

(defun gs-record-word (e) (coerce (mstring e) 'string))

(defun gs-record-error (structure what found)
  ($gs__raise (format nil "gs__record: ~a: ~a ~a" (gs-record-word structure) what
                      (gs-record-word found))))

;;; r@field of one of our structures is what the field holds. (Maxima takes a field that holds a
;;; symbol of its own name for one that was never set and leaves r@field as it is: a scene may well
;;; have a parameter called mass.)
(defun gs-own-structure-p (name)
  (and (get name 'defstruct-template) (eql 0 (search "$GS__" (symbol-name name)))))
(defun gs-field (form)
  (let* ((in (meval (cadr form)))
         (field (caddr form))
         (value ($@-function in field)))
    (if (and (eq value field) (not (gs-own-structure-p (caar in)))) form value)))
(setf (get '$@ 'mfexpr*) #'gs-field)

;;; true if x is a structure of that kind (a symbol such as gs__scene)
(defun $gs__is_struct (x kind) (and (consp x) (eq (caar x) kind)))
;;; true if x is an expression with that head, a symbol or "+", "*", "^"
(defun $gs__has_head (x head)
  (if (symbolp head)
      ($gs__is_struct x head)
      (and (not ($mapatom x)) (equal ($op x) head))))
