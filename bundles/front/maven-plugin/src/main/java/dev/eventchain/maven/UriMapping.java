package dev.eventchain.maven;

import java.io.File;

/** A location of files that are referenced by URI. */
public final class UriMapping {

  /** A full URI or a URI prefix, such as {@code platform:/resource/}. */
  private String uri;

  /** The file or folder for it. */
  private File path;

  String uri() {
    return uri;
  }

  File path() {
    return path;
  }
}
