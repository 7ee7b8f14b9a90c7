;;; scene/freedoms.lisp: the freedoms of a joint, their coordinates and speeds.
(in-package :maxima)

;;; Kinds and directions of the freedoms of a joint (scene/joints.mac), orient resolved: [[kind,
;;; unit vector], ...]
;;; j: gsmbp__joint(name, type, ..., axis, second_, pitch_, orientation_, coordinates, speeds, ...)
(defun $gsmbp__freedom_kinds (j)
  (let ((l nil) (orientation (nth 12 j)))
    (dolist (f (cdr (nth 4 ($gsmbp__row_of (symbol-value '$gsmbp__joint_table) (nth 2 j))))
               (gsmbp-list (nreverse l)))
      (destructuring-bind (kind word) (cdr f)
        (cond ((not (eq kind '$orient)) (push (gsmbp-list (list kind (gsmbp-direction j word))) l))
              ((eq orientation '$euler_parameters)
               (push (gsmbp-list (list '$ball (gsmbp-list (list 0 0 1)))) l))
              (t (dolist (e (cdr orientation)) (push (gsmbp-list (list '$turn e)) l))))))))

(defun gsmbp-direction (j word)
  (case word ($axis (nth 9 j)) ($second (nth 10 j)) (t (mfuncall '$gsmbp__joint_direction j word))))

;;; Freedoms of a joint, structures gsmbp__freedom(kind, direction, coordinates, speeds, pitch_),
;;; from the parent on.
(defun $gsmbp__freedoms (j)
  (let ((q (cdr (nth 13 j))))
    (flet ((take (n) (gsmbp-list (loop repeat n while q collect (pop q)))))
      (gsmbp-list
        (mapcar #'(lambda (f)
                    (destructuring-bind (kind direction) (cdr f)
                      (if (eq kind '$ball)
                          (list '($gsmbp__freedom simp)
                                kind
                                direction
                                (take 4)
                                (nth 14 j)
                                (nth 11 j))
                          (list '($gsmbp__freedom simp)
                                kind
                                direction
                                (take 1)
                                (gsmbp-list nil)
                                (nth 11 j))))) (cdr ($gsmbp__freedom_kinds j)))))))
