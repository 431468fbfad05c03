package dev.eventchain.m2t;

/** How a file that is there already is treated. */
enum FileMode {
  OVERWRITE,
  APPEND,
  CREATE
}
