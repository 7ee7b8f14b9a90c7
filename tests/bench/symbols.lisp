;;; Memory that a computation takes, for the bench of symbols: bytes of list cells consed, all of
;;; them, freed or not (GCL; 0 elsewhere).
(in-package :maxima)

(defvar *bench-consed* 0)   ; cells up to the last collection
(defvar *bench-free* 0)     ; free cells after it

#+gcl (defun bench-free-cells () (car (multiple-value-list (si::allocated 'cons))))

;; room for cells, so that collections are rare, and a hook that keeps count where one comes all the
;; same
(defun $bench_memory_start ()
  #+gcl
  (progn
    (si::allocate 'cons 40000 t)
    (si::gbc t)
    (setq *bench-consed* 0 *bench-free* (bench-free-cells))
    (setq si::*after-gbc-hook*
          #'(lambda (&rest type)
              (declare (ignore type))
              (setq *bench-consed* (+ *bench-consed* *bench-free*)
                    *bench-free* (bench-free-cells)))))
  0)

;; megabytes since then; a cell is two words
(defun $bench_memory_used ()
  #+gcl (/ (* 16.0d0 (+ *bench-consed* (- *bench-free* (bench-free-cells)))) 1d6)
  #-gcl 0)
