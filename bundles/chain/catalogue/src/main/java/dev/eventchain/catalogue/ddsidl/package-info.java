/** Reader of catalogues in DDS IDL. */
package dev.eventchain.catalogue.ddsidl;
