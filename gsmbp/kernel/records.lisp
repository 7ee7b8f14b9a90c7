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
