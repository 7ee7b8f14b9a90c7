;;; scene.lisp: gsmbp_scene: reads, checks and completes a scene.
(in-package :maxima)

;;; An expression as it was typed, not simplified, with exact numbers for the decimals that meet
;;; other numbers: 0.1*3 becomes 3/10, not 0.30000000000000004. A decimal alone stays as it is (and
;;; is shown so in messages).
(defun gsmbp-typed (e calculated)
  (cond ((floatp e) (if calculated ($gsmbp__exact e) e))
        ((or (atom e) (member (caar e) '(bigfloat mrat rat)) (not (gsmbp-inexact-p e))) e)
        (t (let ((inside (and (member (caar e) '(mplus mtimes mexpt mquotient mminus mdifference))
                              (or calculated (> (gsmbp-typed-numbers e) 1)))))
             (cons (list (caar e)) (mapcar #'(lambda (x) (gsmbp-typed x inside)) (cdr e)))))))

;;; how many numbers an expression calculates with; the exponent of a symbol is none
(defun gsmbp-typed-numbers (e)
  (cond ((numberp e) 1)
        ((atom e) 0)
        ((member (caar e) '(rat bigfloat)) 1)
        ((and (eq (caar e) 'mexpt) (symbolp (cadr e))) 0)
        (t (loop for x in (cdr e) sum (gsmbp-typed-numbers x)))))

;;; The elements are neither evaluated nor simplified before their decimals are exact, which no
;;; function of Maxima's language can do.
(defmspec $gsmbp_scene (form)
          (let ((elements (mapcar #'(lambda (x) (gsmbp-typed x nil)) (cddr form))))
            (unless (cdr form)
              ($gsmbp__raise
                "gsmbp_scene: expected gsmbp_scene(name, element, ...); found no argument"))
            (gsmbp-apart
              #'(lambda ()
                  (gsmbp-need-simple elements)
                  (mfuncall '$gsmbp__scene_typed (meval (cadr form))
                            (simplify (cons '(mlist) elements)))))))
