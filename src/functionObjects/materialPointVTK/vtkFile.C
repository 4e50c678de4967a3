// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "vtkFile.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- First lines of a file
std::string vtkHead(const std::string& type, const std::string& attributes = "")
{
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type + "\" version=\"1.0\" byte_order=\""
        + (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? "LittleEndian" : "BigEndian")
        + "\" header_type=\"UInt64\">\n<" + type + attributes + ">\n";
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::vtkFile::declare(
    const std::string& name, const char* type, const int size, const uint64_t bytes)
{
    std::ostringstream os;
    os << "DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << size
       << '"';
    own_ << '<' << os.str() << " format=\"appended\" offset=\"" << bytes_ << "\"/>\n";
    if (listed())
    {
        list_ << "<P" << os.str() << "/>\n";
    }

    // Each array has its length first
    bytes_ += sizeof(bytes) + bytes;
    data_.push_back([bytes](std::ostream& out)
                    { out.write(reinterpret_cast<const char*>(&bytes), sizeof(bytes)); });
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::vtkFile::vtkFile(const std::string& type, const std::string& counts) : type_(type)
{
    own_ << vtkHead(type) << "<Piece " << counts << ">\n";
    list_ << vtkHead("P" + type, " GhostLevel=\"0\"");
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::vtkFile::section(const std::string& name)
{
    if (section_.size())
    {
        own_ << "</" << section_ << ">\n";
        list_ << (listed() ? "</P" + section_ + ">\n" : "");
    }
    section_ = name;
    if (section_.size())
    {
        own_ << '<' << section_ << ">\n";
        list_ << (listed() ? "<P" + section_ + ">\n" : "");
    }
}

Foam::fileName Foam::mpm::vtkFile::write(const fileName& folder, const fileName& name)
{
    section("");
    const std::string kind(type_ == "PolyData" ? "vtp" : "vtu");
    const auto piece = [&](const label proc)
    { return name + (Pstream::parRun() ? '_' + std::to_string(proc) : "") + '.' + kind; };

    mkDir((folder / name).path());
    std::ofstream os(folder / piece(Pstream::myProcNo()), std::ios::binary);
    os << own_.str() << "</Piece>\n</" << type_ << ">\n<AppendedData encoding=\"raw\">\n_";
    for (const writer& values : data_)
    {
        values(os);
    }
    os << "\n</AppendedData>\n</VTKFile>\n";
    os.close();
    bool good = os.good();

    if (Pstream::parRun() && Pstream::master())
    {
        std::ofstream list(folder / name + ".p" + kind);
        list << list_.str();
        for (label proc = 0; proc < Pstream::nProcs(); ++proc)
        {
            list << "<Piece Source=\"" << fileName(piece(proc)).name() << "\"/>\n";
        }
        list << "</P" << type_ << ">\n</VTKFile>\n";
        list.close();
        good = good && list.good();
    }

    // The series has no file before all pieces are there
    if (!returnReduce(good, andOp<bool>()))
    {
        FatalErrorInFunction << "Cannot write " << folder / name << ".*" << exit(FatalError);
    }
    return name + (Pstream::parRun() ? ".p" : ".") + kind;
}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpm::addToSeries(
    const fileName& series, const Time& time, const fileName& file, const bool later)
{
    const std::string start("<DataSet timestep=\"");
    std::map<double, std::string> entries;
    const double now = std::stod(time.timeName());
    std::ifstream is(series);
    for (std::string line; std::getline(is, line);)
    {
        if (line.compare(0, start.size(), start) == 0 && line.substr(line.size() - 2) == "/>")
        {
            const double t = std::strtod(line.c_str() + start.size(), nullptr);
            if (t < now || later)
            {
                entries[t] = line;
            }
        }
    }
    is.close();
    entries[now] = start + time.timeName() + "\" file=\"" + file + "\"/>";

    // A run that is killed here leaves the old one
    const fileName part(series + ".part");
    std::ofstream os(part);
    os << vtkHead("Collection");
    for (const auto& entry : entries)
    {
        os << entry.second << '\n';
    }
    os << "</Collection>\n</VTKFile>\n";
    os.close();
    if (!os.good() || !mv(part, series))
    {
        FatalErrorInFunction << "Cannot write " << series << exit(FatalError);
    }
}
