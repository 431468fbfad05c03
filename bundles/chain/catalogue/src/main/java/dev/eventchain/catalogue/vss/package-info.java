/** Reader of the Vehicle Signal Specification of COVESA. */
package dev.eventchain.catalogue.vss;
