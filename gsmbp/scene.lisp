;;; scene.lisp: gsmbp_scene: reads, checks and completes a scene.
(in-package :maxima)

;;; An expression as it was typed, not simplified, with exact numbers for the decimals that meet
;;; other numbers: 0.1*3 becomes 3/10, not 0.30000000000000004. A decimal alone stays as it is (and
;;; is shown so in messages).
(defun gs-typed (e calculated)
  (cond ((floatp e) (if calculated ($gs__exact e) e))
        ((or (atom e) (member (caar e) '(bigfloat mrat rat)) (not (gs-inexact-p e))) e)
        (t (let ((inside (and (member (caar e) '(mplus mtimes mexpt mquotient mminus mdifference))
                              (or calculated (> (gs-typed-numbers e) 1)))))
             (cons (cons (caar e) (member 'array (cdar e)))   ; f(0.2)[3] stays one
                   (mapcar #'(lambda (x) (gs-typed x inside)) (cdr e)))))))

;;; how many numbers an expression calculates with; the exponent of a symbol is none
(defun gs-typed-numbers (e)
  (cond ((numberp e) 1)
        ((atom e) 0)
        ((member (caar e) '(rat bigfloat)) 1)
        ((and (eq (caar e) 'mexpt) (symbolp (cadr e))) 0)
        (t (loop for x in (cdr e) sum (gs-typed-numbers x)))))

;;; The elements are neither evaluated nor simplified before their decimals are exact, which no
;;; function of Maxima's language can do.
(defmspec $gsmbp_scene (form)
          (let ((elements (mapcar #'(lambda (x) (gs-typed x nil)) (cddr form))))
            (unless (cdr form)
              ($gs__raise
                "gsmbp_scene: expected gsmbp_scene(name, element, ...); found no argument"))
            (gs-apart
              #'(lambda ()
                  (gs-need-no-assignment elements)
                  (gs-need-simple elements)
                  (let ((name (meval (cadr form))))
                    (gs-clear-errors
                      (format nil "gsmbp_scene: scene ~a" (gs-as-written name))
                      #'(lambda ()
                          (mfuncall '$gs__scene_typed name
                                    (simplify (cons '(mlist) elements))))))))))
