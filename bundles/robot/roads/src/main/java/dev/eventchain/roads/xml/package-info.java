/** Reading of OpenDRIVE files as elements with their places, road by road. */
package dev.eventchain.roads.xml;
