package dev.eventchain.m2t.files;

/** Treatment of an existing file. */
public enum FileMode {
  OVERWRITE,
  APPEND,
  CREATE
}
