;;; emit/identity.lisp: checksum of a text and hash of a scene (see emit/identity.mac).
(in-package :maxima)

;;; Sum of a list of lines as Adler-32 forms it (RFC 1950), of their ASCII characters and a newline
;;; each: "b a" in decimal digits
(defun $gs__checksum (lines)
  (let ((a 1) (b 0))
    (declare (fixnum a b))
    (flet ((add (code)
             (declare (fixnum code))
             (when (< code 128) (setq a (mod (+ a code) 65521) b (mod (+ b a) 65521)))))
      (dolist (line (cdr lines))
        (map nil (lambda (c) (add (char-code c))) line)
        (add 10)))
    (format nil "~d ~d" b a)))

;;; Hash of an expression as FNV-1a forms it (64 bits; Fowler, Noll, Vo; prime 1099511628211), of
;;; the names, numbers and texts in it and the parentheses around its operators and arguments: 16
;;; hexadecimal digits. Flags that the simplifier leaves on an operator do not count.
(defun $gs__tree_hash (expression)
  (let ((hash #xcbf29ce484222325))
    (gs-rec ((add (text)
               (map nil
                    #'(lambda (c)
                        (let ((code (char-code c)))
                          (when (< code 128)
                            (setq hash
                                  (ldb (byte 64 0) (* (logxor hash code) 1099511628211))))))
                    text))
             (walk (e)
               (cond ((consp e)
                      (add "(")
                      (walk (if (consp (car e)) (caar e) (car e)))
                      (mapc #'walk (cdr e))
                      (add ")"))
                     ((symbolp e) (add (symbol-name e)) (add " "))
                     ((stringp e) (add "\"") (add e) (add "\""))
                     (t (add (gs-hashed-number e)) (add " ")))))
      (walk expression))
    (format nil "~(~16,'0x~)" hash)))

;;; a structure without its last field, which Maxima 5.49 does not let pass as one
(defun $gs__all_but_last (e)
  (cons (car e) (butlast (cdr e))))

;;; the digits of a number, whatever base the session prints in
(defun gs-hashed-number (x)
  (with-standard-io-syntax (prin1-to-string (if (floatp x) (rational x) x))))
