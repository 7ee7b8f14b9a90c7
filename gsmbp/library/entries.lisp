;;; library/entries.lisp: the fields of entries and devices, which a scene is asked for thousands of
;;; times.
(in-package :maxima)

;;; what a field of an entry or a variant [field = value, ...] holds, else false; a field that is a
;;; list, an expression: empty, zero where it is missing
(defun $gs__field (fields name) (caddr (find name (cdr fields) :key #'cadr :test #'eq)))
(defun $gs__list_field (fields name)
  (let ((x ($gs__field fields name))) (if ($listp x) x (gs-list nil))))
(defun $gs__value_field (fields name) (or ($gs__field fields name) 0))

;;; the symbol of a device of the scene for a symbol of its entry
(defun $gs__own (device symbol) ($concat ($@-function device '$name) "_" symbol))

;;; The fields of the variant that a device uses; fields of the entry itself where the variant is
;;; silent. Of the variants the first, where the scene says nothing.
(defun $gs__variant_fields (device)
  (let ((entry (gs-entry-of device)))
    (gs-list (append (cdr ($gs__field (gs-variants entry) ($gs__variant_name device)))
                     (cdr entry)))))
(defun $gs__variant_name (device)
  (or ($@-function device '$variant) (cadr (cadr (gs-variants (gs-entry-of device))))))
(defun gs-variants (entry) ($gs__field entry '$variants))
(defun gs-entry-of (device) (mfuncall '$gs__entry ($@-function device '$kind)))

;;; Value of a parameter of a device: the option as written (number or expression), else a parameter
;;; of its own; its ratio, 1 where none is given
;;; (a default that is an expression of other parameters is no parameter: that expression of theirs)
(defun $gs__device_value (device symbol)
  (or (gs-option device symbol)
      (let ((default (gs-default device symbol)))
        (and default (not ($numberp default)) ($gs__device_expression device default)))
      ($gs__own device symbol)))
;;; an expression of the entry's parameters by what the scene gives for them
(defun $gs__device_expression (device e)
  (mfuncall '$sublis
            (gs-list (mapcar #'(lambda (s) (list '(mequal) s ($gs__device_value device s)))
                             (cdr ($listofvars e))))
            e))
(defun gs-default (device symbol)
  (let ((parameters ($gs__list_field (gs-entry-of device) '$parameters)))
    (third (find symbol (cdr parameters) :key #'cadr :test #'eq))))
(defun $gs__ratio (device) (or (gs-option device '$ratio) 1))
(defun gs-option (device symbol) ($gs__field ($@-function device '$options) symbol))

;;; a device that acts at instants only (a digital controller)
(defun $gs__is_sampled (device) (and ($gs__field ($gs__variant_fields device) '$period) t))
