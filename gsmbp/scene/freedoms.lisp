;;; scene/freedoms.lisp: the freedoms of a joint, their coordinates and speeds.
(in-package :maxima)

;;; Kinds and directions of the freedoms of a joint (scene/joints.mac), orient resolved: [[kind,
;;; unit vector], ...]
;;; j: gs__joint(name, type, ..., axis, second_, pitch_, orientation_, coordinates, speeds, ...,
;;; modes); the freedoms of a beam's section are its modes
(defun $gs__freedom_kinds (j)
  (let ((l nil) (orientation (nth 12 j)))
    (dolist (kind (cdr (nth 20 j))) (push (gs-list (list kind (gs-list (list 0 0 1)))) l))
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

;;; speed of a coordinate: q1_d
(defun $gs__speed (q) ($concat q "_d"))

;;; unit of the coordinate of a freedom of one
(defun gs-unit-of-freedom (kind) (if (member kind '($slide $bend $stretch)) "m" "rad"))
(defun $gs__unit_of_freedom (kind) (gs-unit-of-freedom kind))

;;; [symbol, unit, kind] of every coordinate, [symbol, unit] of every speed of a joint; a ball's
;;; parameters have no unit
(defun gs-of-freedoms (f j)
  (gs-list (loop for freedom in (cdr ($gs__freedoms j))
                 append (destructuring-bind (kind direction q speeds pitch) (cdr freedom)
                          (declare (ignore direction pitch))
                          (funcall f kind (cdr q) (cdr speeds))))))
(defun $gs__joint_coordinates (j)
  (gs-of-freedoms
    #'(lambda (kind coordinates speeds)
        (declare (ignore speeds))
        (let ((unit (if (eq kind '$spherical) "" (gs-unit-of-freedom kind))))
          (mapcar #'(lambda (q) (gs-list (list q unit kind))) coordinates)))
    j))
(defun $gs__joint_speeds (j)
  (gs-of-freedoms
    #'(lambda (kind coordinates speeds)
        (if (eq kind '$spherical)
            (mapcar #'(lambda (w) (gs-list (list w "rad/s"))) speeds)
            (list (gs-list (list ($gs__speed (car coordinates))
                                 (gs-text (gs-unit-of-freedom kind) "/s"))))))
    j))

;;; the joints of the tree that have coordinates, in scene order
(defun $gs__moving_joints (scene)
  (gs-list (remove-if-not #'(lambda (j) (cdr (nth 13 j))) (cdr ($@-function scene '$joints)))))
(defun gs-of-joints (f scene)
  (gs-list (loop for j in (cdr ($gs__moving_joints scene)) append (cdr (funcall f j)))))

;;; The rates of the scene: of every coordinate q its rate q_d, of Euler parameters the angular
;;; velocity: [symbol, unit]; the units of the coordinates; the freedoms of balls.
(defun $gs__scene_rates (scene) (gs-of-joints #'$gs__joint_speeds scene))
(defun $gs__coordinate_units (scene)
  (gs-list (mapcar #'caddr (cdr (gs-of-joints #'$gs__joint_coordinates scene)))))
(defun $gs__spherical_freedoms (scene)
  (gs-list (remove '$spherical (cdr (gs-of-joints #'$gs__freedoms scene))
                   :key #'cadr :test-not #'eq)))
