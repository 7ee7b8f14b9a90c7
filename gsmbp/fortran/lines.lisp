;;; fortran/lines.lisp: statements and declarations given in pieces, as lines of fixed form.
(in-package :maxima)

(declaim (special $gs__indent))

;;; A statement given in pieces, broken between them where that will do; indented by gs__indent.
(defun $gs__packed_lines (pieces)
  (let* ((lines nil) (in (make-string $gs__indent :initial-element #\Space))
         (line (list (gs-text "      " in))) (width (- 66 $gs__indent)))
    (dolist (p (cdr pieces) (gs-list (nreverse (cons (gs-joined (nreverse line) "") lines))))
      (cond ((<= (length p) width) (push p line) (decf width (length p)))
            (t (push (gs-joined (nreverse line) "") lines)
               (setq p (string-left-trim " " p)
                     line (list p (gs-text "     $   " in))
                     width (- 63 $gs__indent (length p)))
               (when (< width 0)
                 (return (mfuncall '$gs__statement_lines (gs-joined (cdr pieces) "") ""
                                   $gs__indent))))))))

;;; the declaration of some names, or several if one would need more than 20 lines
(defun $gs__declaration (type names) (gs-list (gs-declared type (cdr names))))
(defun gs-declared (type names)
  (let* ((n (length names)) (half (floor n 2))
         (lines (if (<= 1 n 200)
                    (cdr ($gs__packed_lines
                           (gs-list
                             (cons (gs-text type (car names) (if (cdr names) "," ""))
                                   (maplist #'(lambda (l)
                                                (gs-text " " (car l) (if (cdr l) "," "")))
                                            (cdr names)))))))))
    (cond ((null names) nil)
          ((and lines (<= (length lines) 20)) lines)
          (t (mapcan #'(lambda (part) (gs-declared type (cdr part)))
                     (cdr ($gs__cut_at (gs-list names) half)))))))

