;; trig/simplify.lisp: the terms of an expanded sum by what stands beside their sines and cosines
;; (twenty times faster than in Maxima). ((mlist) ((mlist) c t1 t2 ...) ...) with e = sum of c*(t1 +
;; t2 + ...); a t is a number times powers of symbols in the hash table.
(in-package :maxima)

(defun gs-trig-factor-p (f table)
  (cond ((numberp f) t)
        ((symbolp f) (gethash f table))
        ((eq (caar f) 'rat) t)
        ((eq (caar f) 'mexpt)
         (and (symbolp (cadr f)) (integerp (caddr f)) (gethash (cadr f) table)))))

(defun gs-product (factors)   ; of factors that stood in this order in a simplified product
  (cond ((null factors) 1) ((null (cdr factors)) (car factors)) (t (cons '(mtimes simp) factors))))

(defun $gs__trig_classes (e table)
  (gs-tick)
  (let ((classes (make-hash-table :test #'equal)) (keys nil))
    (mapc #'(lambda (term)
              (let ((own nil) (beside nil))
                (mapc #'(lambda (f)
                          (if (consp f) (setq f ($gs__unmarked f)))
                          (if (gs-trig-factor-p f table)
                              (setq own (cons f own))
                              (setq beside (cons f beside))))
                      (if (and (consp term) (eq (caar term) 'mtimes)) (cdr term) (list term)))
                (setq own (gs-product (reverse own)) beside (gs-product (reverse beside)))
                (let ((others (gethash beside classes)))
                  (if (null others) (setq keys (cons beside keys)))
                  (setf (gethash beside classes) (cons own others)))))
          (if (and (consp e) (eq (caar e) 'mplus)) (cdr e) (list e)))
    (cons '(mlist simp)
          (mapcar #'(lambda (k) (cons '(mlist simp) (cons k (reverse (gethash k classes)))))
                  (reverse keys)))))

;;; whether an expression has more than `most` nodes
(defun $gs__is_longer (e most)
  (labels ((count-nodes (x)
             (when (< (decf most) 0) (return-from $gs__is_longer t))
             (unless (atom x) (mapc #'count-nodes (cdr x)))))
    (count-nodes e)
    nil))
