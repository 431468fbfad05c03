package dev.eventchain.roads.road;

/**
 * The header of a file.
 *
 * @param minorVersion of OpenDRIVE 1, such as 8
 * @param name of the network; often empty
 * @param vendor of the program that wrote the file; often empty
 * @param geoReference the projection as a PROJ string; empty if the network has none
 * @param offset from the coordinates of the file to those of the projection
 */
public record Header(
    int minorVersion, String name, String vendor, String geoReference, Offset offset) {

  /**
   * A translation, after a rotation about z.
   *
   * @param x in m
   * @param y in m
   * @param z in m
   * @param heading in rad
   */
  public record Offset(double x, double y, double z, double heading) {}
}
