;;; hostile_options(): the names of Maxima's options that are true or false, or a small number;
;;; with_hostile(names, form): form evaluated with these options turned round, [its value, the
;;; options that it changed].
(in-package :maxima)

(defun hostile-value (v) (cond ((eq v t) nil) ((null v) t) ((integerp v) (+ v 3))))

(defun $hostile_options ()
  (let ((l nil))
    (maphash
      (lambda (s v)
        (when (and (boundp s)
                   (not (get s 'assign))
                   (or (member v '(t nil)) (and (integerp v) (< 0 v 100)))
                   (not (gs-kept-p s)))
          (push s l)))
      *variable-initial-values*)
    (cons '(mlist) (sort l #'string< :key #'symbol-name))))

(defmspec $with_hostile (form)
          (let ((names (cdr (meval (cadr form)))) (e (caddr form)) (value nil) (changed nil)
                (before nil))
            (setq before (mapcar #'symbol-value names))
            (unwind-protect (progn
              (dolist (s names) (setf (symbol-value s) (hostile-value (symbol-value s))))
              (setq value (meval e))
              (mapc (lambda (s v)
                      (unless (equal (symbol-value s) (hostile-value v)) (push s changed))) names
                    before))
              (mapc (lambda (s v) (setf (symbol-value s) v)) names before))
            (list '(mlist) value (cons '(mlist) changed))))

(defun $same_bytes (a b)
  (and (probe-file a) (probe-file b)
       (with-open-file (x a) (with-open-file (y b)
         (loop (let ((l (read-line x nil :end)) (m (read-line y nil :end)))
                 (cond ((not (equal l m)) (return nil)) ((eq l :end) (return t)))))))))
