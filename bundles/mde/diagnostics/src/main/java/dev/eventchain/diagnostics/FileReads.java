package dev.eventchain.diagnostics;

import java.nio.file.Path;
import java.util.Collections;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Supplier;

/**
 * Record of the files that a piece of work reads. Those who read a file note it where they read it;
 * those who want to know what a result depends on record the work. Work in threads that it starts
 * belongs to it.
 */
public final class FileReads {

  private static final InheritableThreadLocal<FileReads> CURRENT = new InheritableThreadLocal<>();

  /** Files that the whole work reads, whatever parts of it record or leave out. */
  private static final InheritableThreadLocal<Set<Path>> ALL = new InheritableThreadLocal<>();

  private final SortedSet<Path> files = Collections.synchronizedSortedSet(new TreeSet<>());

  private FileReads() {}

  /**
   * The value that work has returned.
   *
   * @param files the files that it read or tried to read, absolute and normalized
   */
  public record Recorded<T>(T value, SortedSet<Path> files) {}

  /** Notes that the current work reads a file, whether the file exists or not. */
  public static void note(Path file) {
    WorkScope.current(CURRENT).ifPresent(work -> work.files.add(file.toAbsolutePath().normalize()));
    WorkScope.current(ALL).ifPresent(all -> all.add(file.toAbsolutePath().normalize()));
  }

  /** Does work and records what it reads, which the surrounding work has read, too. */
  public static <T> Recorded<T> record(Supplier<T> work) {
    FileReads reads = new FileReads();
    T value = WorkScope.during(CURRENT, reads, work);
    WorkScope.current(CURRENT).ifPresent(outer -> outer.files.addAll(reads.files));
    return new Recorded<>(value, Collections.unmodifiableSortedSet(new TreeSet<>(reads.files)));
  }

  /**
   * Does work and records everything that it reads, also in {@link #unrecorded} parts and in those
   * that fail: for who does the work again when anything has changed. Such work is never a part of
   * other such work.
   */
  public static <T> Recorded<T> recordAll(Supplier<T> work) {
    SortedSet<Path> all = Collections.synchronizedSortedSet(new TreeSet<>());
    T value = recordAll(all, work);
    return new Recorded<>(value, Collections.unmodifiableSortedSet(new TreeSet<>(all)));
  }

  /**
   * As above, for who wants to know meanwhile what has been read.
   *
   * @param files receives the files, absolute and normalized; thread-safe
   */
  public static <T> T recordAll(Set<Path> files, Supplier<T> work) {
    return WorkScope.during(ALL, files, work);
  }

  /** Does work that reads nothing on which the result of the surrounding work depends. */
  public static <T> T unrecorded(Supplier<T> work) {
    return WorkScope.during(CURRENT, new FileReads(), work);
  }
}
