package dev.eventchain.m2t.files;

/** How a file that is there already is treated. */
public enum FileMode {
  OVERWRITE,
  APPEND,
  CREATE
}
