;;; scene/freedoms.lisp: the freedoms of a joint, their coordinates and speeds.
(in-package :maxima)

;;; Kinds and directions of the freedoms of a joint (scene/joints.mac), orient resolved: [[kind,
;;; unit vector], ...]
;;; j: gs__joint(name, type, ..., axis, second_, pitch_, orientation_, coordinates, speeds, ...)
(defun $gs__freedom_kinds (j)
  (let ((l nil) (orientation (nth 12 j)))
    (dolist (f (cdr (nth 4 ($gs__row_of (symbol-value '$gs__joint_table) (nth 2 j))))
               (gs-list (nreverse l)))
      (destructuring-bind (kind word) (cdr f)
        (cond ((not (eq kind '$orient)) (push (gs-list (list kind (gs-direction j word))) l))
              ((eq orientation '$euler_parameters)
               (push (gs-list (list '$spherical (gs-list (list 0 0 1)))) l))
              (t (dolist (e (cdr orientation)) (push (gs-list (list '$turn e)) l))))))))

(defun gs-direction (j word)
  (case word ($axis (nth 9 j)) ($second (nth 10 j)) (t (mfuncall '$gs__joint_direction j word))))

;;; Freedoms of a joint, structures gs__freedom(kind, direction, coordinates, speeds, pitch_),
;;; from the parent on.
(defun $gs__freedoms (j)
  (let ((q (cdr (nth 13 j))))
    (flet ((take (n) (gs-list (loop repeat n while q collect (pop q)))))
      (gs-list
        (mapcar #'(lambda (f)
                    (destructuring-bind (kind direction) (cdr f)
                      (if (eq kind '$spherical)
                          (list '($gs__freedom simp)
                                kind
                                direction
                                (take 4)
                                (nth 14 j)
                                (nth 11 j))
                          (list '($gs__freedom simp)
                                kind
                                direction
                                (take 1)
                                (gs-list nil)
                                (nth 11 j))))) (cdr ($gs__freedom_kinds j)))))))
