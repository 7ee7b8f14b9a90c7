;;; topic_opens(name): whether describe of Maxima finds a text of GSMBP's manual for the name that
;;; tells of it. (describe itself asks which one is meant where Maxima has such a topic, too.)
(in-package :maxima)

(defun $topic_opens (name)
  (loop for (folder matches) in (cl-info::exact-topic-match name)
        thereis (and (search "share/manual" (namestring folder))
                     (some #'(lambda (match)
                               (let ((text (cl-info::read-info-text folder match)))
                                 (and (eql 1 (search "-- " text :end2 (min 8 (length text))))
                                      (search name text :test #'char-equal) t)))
                           matches))))
