package dev.eventchain.maven;

import java.io.File;

/** Where to find the files that references name by a URI. */
public final class UriMapping {

  /** A whole URI, or what URIs begin with: {@code platform:/resource/}. */
  private String uri;

  /** The file that it means, or the folder. */
  private File path;

  String uri() {
    return uri;
  }

  File path() {
    return path;
  }
}
