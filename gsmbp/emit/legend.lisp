;;; emit/legend.lisp: of which links and devices a constant is (twenty times faster than in
;;; Maxima where it is made of hundreds of parameters).
(in-package :maxima)

;;; gs__owners_by_mass(leaves, heavy, owners): the owners of those parameters that are in the table
;;; heavy; what several have in common counts as that of those which own the rest of the constant
;;; too, where there are such. Without such parameters: the owners of all.
(defun $gs__owners_by_mass (leaves heavy owners)
  (labels ((heavy-p (x) (gethash x heavy))
           (owned (symbols) (loop for x in symbols append (cdr (gethash x owners)))))
    (let ((masses (remove-if-not #'heavy-p (cdr leaves)))
          (others (owned (remove-if #'heavy-p (cdr leaves)))))
      (labels ((shared-p (owner) (member owner others :test #'equal))
               (narrowed (own) (or (and (cdr own) (remove-if-not #'shared-p own)) own)))
        (gs-list
          (gs-first-seen
            (if masses (loop for x in masses append (narrowed (owned (list x)))) others)))))))
