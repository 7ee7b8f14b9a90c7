;;; fortran/legend.lisp: of which links and devices a constant is (twenty times faster than in
;;; Maxima where it is made of hundreds of parameters).
(in-package :maxima)

(defun gs-first-seen (lists)
  (let ((seen (make-hash-table :test #'equal)) (r nil))
    (dolist (l lists (nreverse r))
      (dolist (x l)
        (unless (gethash x seen)
          (setf (gethash x seen) t)
          (push x r))))))

;;; gs__owners_by_mass(leaves, heavy, owners): the owners of those parameters that are in the table
;;; heavy; what several have in common counts as that of those which own the rest of the constant
;;; too, where there are such. Without such parameters: the owners of all.
(defun $gs__owners_by_mass (leaves heavy owners)
  (flet ((owned (x) (cdr (gethash x owners))))
    (let ((masses (remove-if-not #'(lambda (x) (gethash x heavy)) (cdr leaves)))
          (rest (gs-first-seen
                  (loop for x in (cdr leaves) unless (gethash x heavy) collect (owned x)))))
      (cons '(mlist simp)
            (if masses
                (gs-first-seen
                  (loop for x in masses
                        collect (let ((own (owned x)))
                                  (or (and (cdr own)
                                           (remove-if-not
                                             #'(lambda (o) (member o rest :test #'equal)) own))
                                      own))))
                rest)))))
